// One Verlet step of a particle: named functions on values.
//
// `a` is the acceleration without drag, `d` = x_n - x_(n-1), `ratio` r = dt_n/dt_o and `a_factor`
// h = dt_n (dt_n + dt_o)/2, which is dt^2 while the step stays the same:
//
//     x_(n+1) = x_n + r d + h a                                             (hard case 28)
//
// With drag -c v and G = c dt/m: lagged v = d/dt, Georgii and Westermann eq. (2); central
// v = (x_(n+1) - x_(n-1))/2dt.
#pragma once

#include "base/vec3.h"
#include "state/particles.h"
#include "state/step.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// r and h of a cloth.
template <class T>
struct Pace {
  T ratio, a_factor;
};
/// The start displacements of a cloth that has not moved yet belong to the substep to come, however
/// long the others' last one was.
template <class T>
WEFT_HD Pace<T> pace_of(const StepParams<T>& step, const ClothParams<T>& cloth) {
  const bool as_new = step.newcomers && cloth.starting != 0;
  return {as_new ? T(1) : step.ratio, as_new ? step.square : step.a_factor};
}
/// 1 / the step that the displacements of a cloth took.
template <class T>
WEFT_HD T per_dt_of(const StepParams<T>& step, const ClothParams<T>& cloth) {
  return pace_of(step, cloth).ratio / step.dt;
}

template <class T, class Pace>
WEFT_HD Vec3<T> next_displacement(Vec3<T> d, Vec3<T> a, const Pace& step) {
  return step.ratio * d + step.a_factor * a;
}
/// d' = (1 - G) r d + h a
template <class T, class Pace>
WEFT_HD Vec3<T> next_displacement_lagged(Vec3<T> d, Vec3<T> a, T g, const Pace& step) {
  return ((T(1) - g) * step.ratio) * d + step.a_factor * a;
}
/// (1 + G/2) d' = (1 - G/2) r d + h a
template <class T, class Pace>
WEFT_HD Vec3<T> next_displacement_central(Vec3<T> d, Vec3<T> a, T g, const Pace& step) {
  const T half = T(0.5) * g;
  const Vec3<T> sum = ((T(1) - half) * step.ratio) * d + step.a_factor * a;
  const T scale = T(1) + half;
  return {sum.x / scale, sum.y / scale, sum.z / scale};
}
/// x' = (1 + r) x - r x_prev + h a: the papers' 2x - x_prev + a dt^2 at a constant step.
template <class T, class Pace>
WEFT_HD Vec3<T> next_position(Vec3<T> x, Vec3<T> previous, Vec3<T> a, const Pace& step) {
  return ((T(1) + step.ratio) * x - step.ratio * previous) + step.a_factor * a;
}
/// Displacement before the first step, from d = v0 dt: v0 dt - (a - c v0/m) dt^2/2, which makes
/// the first step x0 + v0 dt + a0 dt^2/2 with a0 from drag too.
template <class T>
WEFT_HD Vec3<T> taylor_start(Vec3<T> d, Vec3<T> a, T g, const StepParams<T>& step) {
  return (T(1) + T(0.5) * g) * d - (T(0.5) * step.dt * step.dt) * a;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
