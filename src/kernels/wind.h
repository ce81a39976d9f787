// Wind on triangles: drag across and along the surface, quadratic in the relative velocity.
#pragma once

#include "kernels/displacement.h"
#include "kernels/fan.h"
#include "state/step.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// A third of (rho A/2) [normal |u.n| (u.n) n + tangential |u_t| u_t] with u = wind - v, u_t = u -
/// (u.n) n. In terms of N = 2 A n, whose length is never needed:
///
///     (rho normal/12) |u.N| (u.N) N/N^2  +  (rho tangential/12) |N| |u_t| u_t
///
/// with the force per relative velocity, by which a step could overshoot, as weight (N s/m). A
/// triangle without area has no wind (hard case 7).
template <class T>
WEFT_HD TriangleShare<T> wind_on_triangle(const Wind<T>& wind, Vec3<T> area_normal, Vec3<T> u) {
  const T square = dot(area_normal, area_normal), flow = dot(u, area_normal);
  const bool has_area = square > T(0);
  const T per_square = T(1) / (has_area ? square : T(1));
  const T through = flow < T(0) ? -flow : flow;
  const Vec3<T> along = u - (flow * per_square) * area_normal;
  const T across_part = wind.normal * through;
  const T along_part = wind.tangential * square_root(square * dot(along, along));
  const Vec3<T> force = (across_part * flow * per_square) * area_normal + along_part * along;
  return {select(has_area, force, Vec3<T>{T(0), T(0), T(0)}),
          has_area ? larger(across_part, along_part) : T(0)};
}

/// Adds the wind to the forces of a block, limited so that a step never reverses the relative
/// velocity: f / (1 + C dt/m) with C the sum of the weights. For one drag -b |w| w that is the step
/// w' = w/(1 + b |w| dt/m) of hard case 60. Velocities are the mean displacements * per_dt.
template <bool Position, class T, class Fan, int N>
WEFT_HD void add_wind(const Fan& fan, const ClothParams<T>& cloth, const ParticleBuffers<T>& of,
                      const StepParams<T>& step, const T* inverse_mass, int block, int i0,
                      Lanes<N> lanes, LaneVec3<T, N>& force) {
  // Copies: g++ vectorises no loop that reads through references.
  const ParticleBuffers<T> p = of;
  const Wind<T> wind = step.wind;
  const T third_per_dt = step.ratio / (T(3) * step.dt), dt = step.dt;
  LaneVec3<T, N> sum;
  T weight[N];
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
      sum, weight);
  lanes.each([&](int l) WEFT_LANE {
    const T limit = T(1) + weight[l] * (dt * inverse_mass[i0 + l]);
    force.set(l, force.get(l) + (T(1) / limit) * sum.get(l));
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
