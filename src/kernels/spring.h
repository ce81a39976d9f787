// The force of one spring.
#pragma once

#include "base/vec3.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Force on the end i of a spring: k (l - l0)/l (x_j - x_i), with `to` = x_j - x_i and l its
/// length. Georgii and Westermann 2005, eq. (1); Fratarcangeli 2011, section 22.2; both with the
/// sign that they mean. A spring of no length pulls nothing, so "neighbour = self" is the null
/// spring.
template <class T>
WEFT_HD Vec3<T> spring_force(Vec3<T> to, T stiffness, T rest) {
  const T length = square_root(dot(to, to));
  const T tension = length > T(0) ? stiffness * (length - rest) / length : T(0);
  return tension * to;
}

/// Damping force on the end i: b ((v_j - v_i).n) n with n = to/|to| and `velocity` = v_j - v_i.
template <class T>
WEFT_HD Vec3<T> spring_damping_force(Vec3<T> to, Vec3<T> velocity, T damping) {
  const T length2 = dot(to, to);
  const T rate = length2 > T(0) ? damping * dot(velocity, to) / length2 : T(0);
  return rate * to;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
