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
#include "state/step.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T>
WEFT_HD Vec3<T> next_displacement(Vec3<T> d, Vec3<T> a, const StepParams<T>& step) {
  return step.ratio * d + step.a_factor * a;
}
/// d' = (1 - G) r d + h a
template <class T>
WEFT_HD Vec3<T> next_displacement_lagged(Vec3<T> d, Vec3<T> a, T g, const StepParams<T>& step) {
  return ((T(1) - g) * step.ratio) * d + step.a_factor * a;
}
/// (1 + G/2) d' = (1 - G/2) r d + h a
template <class T>
WEFT_HD Vec3<T> next_displacement_central(Vec3<T> d, Vec3<T> a, T g, const StepParams<T>& step) {
  const T half = T(0.5) * g;
  const Vec3<T> sum = ((T(1) - half) * step.ratio) * d + step.a_factor * a;
  const T scale = T(1) + half;
  return {sum.x / scale, sum.y / scale, sum.z / scale};
}
/// x' = (1 + r) x - r x_prev + h a: the papers' 2x - x_prev + a dt^2 at a constant step.
template <class T>
WEFT_HD Vec3<T> next_position(Vec3<T> x, Vec3<T> previous, Vec3<T> a, const StepParams<T>& step) {
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
