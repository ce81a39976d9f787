// Wind on triangles: drag across and along the surface, quadratic in the relative velocity.
#pragma once

#include "kernels/displacement.h"
#include "kernels/fan.h"
#include "kernels/integrate.h"
#include "state/step.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// What the triangles do to a vertex: the force, and the matrix K (N s/m) with force = K u.
template <class T>
struct Blow {
  Vec3<T> force;
  T along;                ///< K = along 1 +
  Vec3<T> square, mixed;  ///< a symmetric matrix: xx yy zz, yz zx xy
};
template <class T>
WEFT_HD Blow<T> operator+(const Blow<T>& a, const Blow<T>& b) {
  return {a.force + b.force, a.along + b.along, a.square + b.square, a.mixed + b.mixed};
}

/// A Blow per lane.
template <class T, int N>
struct LaneBlow {
  LaneVec3<T, N> force, square, mixed;
  alignas(N == 1 ? alignof(T) : 64) T along[N];

  WEFT_HD Blow<T> get(int l) const { return {force.get(l), along[l], square.get(l), mixed.get(l)}; }
  WEFT_HD void set(int l, const Blow<T>& blow) {
    force.set(l, blow.force);
    along[l] = blow.along;
    square.set(l, blow.square);
    mixed.set(l, blow.mixed);
  }
};

/// A third of (rho A/2) [normal |u.n| (u.n) n + tangential |u_t| u_t] with u = wind - v, u_t = u -
/// (u.n) n. In terms of N = 2 A n, whose length is never needed:
///
///     (rho normal/12) |u.N| (u.N) N/N^2  +  (rho tangential/12) |N| |u_t| u_t
///
/// A triangle without area has no wind (hard case 7).
template <class T>
WEFT_HD Blow<T> wind_on_triangle(const Wind<T>& wind, Vec3<T> area_normal, Vec3<T> u) {
  const T square = dot(area_normal, area_normal), flow = dot(u, area_normal);
  const bool has_area = square > T(0);
  const T per_square = T(1) / (has_area ? square : T(1));
  const T through = flow < T(0) ? -flow : flow;
  const Vec3<T> slip = u - (flow * per_square) * area_normal;
  const T along = has_area ? wind.tangential * square_root(square * dot(slip, slip)) : T(0);
  const T across = has_area ? wind.normal * through : T(0);
  const Vec3<T> n = area_normal, more = ((across - along) * per_square) * n;
  return {flow * more + along * u,
          along,
          {more.x * n.x, more.y * n.y, more.z * n.z},
          {more.y * n.z, more.z * n.x, more.x * n.y}};
}

/// y with (1 + s K) y = q. K has no negative eigenvalue, so that no pivot is below 1 but by
/// rounding.
template <class T>
WEFT_HD Vec3<T> relaxed(const Blow<T>& k, T s, Vec3<T> q) {
  const T one = T(1), rest = one + s * k.along, xy = s * k.mixed.z, xz = s * k.mixed.y;
  const T per_x = one / (rest + s * k.square.x);
  const T yx = xy * per_x, zx = xz * per_x;
  const T per_y = one / larger(rest + s * k.square.y - yx * xy, one);
  const T yz = s * k.mixed.x - zx * xy, zy = yz * per_y;
  const T pivot_z = larger(rest + s * k.square.z - zx * xz - zy * yz, one);
  const T y = q.y - yx * q.x, z = (q.z - zx * q.x - zy * y) / pivot_z;
  const T middle = y * per_y - zy * z;
  return {q.x * per_x - yx * middle - zx * z, middle, z};
}

/// Adds the wind to the forces of a block, which are complete without it, and makes of their sum
/// what a step may take. Wind changes while it accelerates: with K u, u lagged by half a step, and
/// tau the time that the velocity is advanced by, the acceleration y of all forces follows from
///
///     (1 + tau K/m) y = (forces + K u)/m + gravity - drag
///
/// It is zero where the forces are in balance, whatever the step. Where nothing else acts, u' =
/// u/(1 + tau K/m) never reverses, and one drag b |u| u is hard case 60: w' = w/(1 + b |w| dt/m).
/// K is half the derivative of the force across the surface and along the slip, so that y is that
/// at the time of the positions to second order where the corners of a triangle accelerate alike.
/// Velocities are the mean displacements * per_dt.
template <bool Position, class T, class Fan, int N>
WEFT_HD void add_wind(const Fan& fan, const ClothParams<T>& cloth, const ParticleBuffers<T>& of,
                      const StepParams<T>& step, const T* inverse_mass, int block, int i0,
                      Lanes<N> lanes, LaneVec3<T, N>& force) {
  // Copies: g++ vectorises no loop that reads through references.
  const ParticleBuffers<T> p = of;
  const Wind<T> wind = step.wind;
  const Vec3<T> gravity = step.gravity;
  const Pace<T> pace = pace_of(step, cloth);
  const T third_per_dt = pace.ratio / (T(3) * step.dt), tau = pace.a_factor / step.dt;
  const T drag_per = cloth.drag * pace.ratio / tau;  // what integration takes of a displacement
  LaneBlow<T, N> sum;
  fan.sum_triangles(
      cloth, block, i0, lanes,
      [=](int i) WEFT_LANE {
        return Corner<T>{load(p.x_in, i), displacement<Position>(p, i)};
      },
      [=](const Corner<T>& here, const Corner<T>& next, const Corner<T>& last) WEFT_LANE {
        const Vec3<T> d = (here.d + next.d) + last.d;
        return wind_on_triangle(wind, cross(next.x - here.x, last.x - here.x),
                                wind.velocity - third_per_dt * d);
      },
      sum);
  lanes.each([&](int l) WEFT_LANE {
    const T w = inverse_mass[i0 + l], mass = w > T(0) ? T(1) / w : T(0);
    const Blow<T> blow = sum.get(l);
    const Vec3<T> braked = (drag_per * w) * displacement<Position>(p, i0 + l) - gravity;
    const Vec3<T> y = relaxed(blow, tau * w, w * (force.get(l) + blow.force) - braked);
    force.set(l, mass * (y + braked));
  });
}

/// The stage of a substep; one function on the host for all kinds of springs.
template <class T, class Fan, int N>
WEFT_HD_COLD void blow(const Fan& fan, const ClothParams<T>& cloth, const ParticleBuffers<T>& p,
                       const StepParams<T>& step, const T* inverse_mass, int block, int i0,
                       Lanes<N> lanes, LaneVec3<T, N>& force) {
  if (step.position_form) {
    add_wind<true>(fan, cloth, p, step, inverse_mass, block, i0, lanes, force);
  } else {
    add_wind<false>(fan, cloth, p, step, inverse_mass, block, i0, lanes, force);
  }
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
