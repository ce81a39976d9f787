// Analytic colliders: a particle inside goes to the surface along the normal (Fratarcangeli 2011,
// section 22.3). Frictionless: only the normal component changes.
#pragma once

#include "state/colliders.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// What moves x out of the sphere whose centre is c; zero outside. The very centre leaves along +y.
template <class T>
WEFT_HD Vec3<T> out_of_sphere(Vec3<T> x, Vec3<T> c, T radius) {
  const Vec3<T> from = x - c;
  const T distance = square_root(dot(from, from));
  const bool at_center = !(distance > T(0));
  const T outward = radius / (at_center ? T(1) : distance);
  const Vec3<T> surface = c + select(at_center, Vec3<T>{T(0), radius, T(0)}, outward * from);
  return select(distance < radius, surface - x, Vec3<T>{T(0), T(0), T(0)});
}

/// What moves x onto the plane dot(normal, x) = offset; zero above it.
template <class T>
WEFT_HD Vec3<T> out_of_plane(Vec3<T> x, Vec3<T> normal, T offset) {
  const T depth = offset - dot(normal, x);
  return (depth > T(0) ? depth : T(0)) * normal;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
