// Spring forces of a grid, gathered: every particle sums over its stencil.
//
// Fratarcangeli 2011, Listing 22.1, step 5. Topology is implicit; a neighbour is a constant
// distance away in memory. Blocks whose particles have all neighbours skip the presence bits. In
// the others a missing neighbour is loaded all the same (guard bands make that legal) and replaced
// by the particle itself, which pulls nothing.
#pragma once

#include "base/lanes.h"
#include "kernels/displacement.h"
#include "kernels/fan.h"
#include "kernels/spring.h"
#include "kernels/stencil.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T, class Stencil>
struct GridSprings {
  using Fan = GridFan<T>;
  static constexpr int neighbours = Stencil::neighbours;
  const uint16_t* presence;
  const uint8_t* inner;

  static constexpr bool uneven = false;
  static constexpr bool projected = false;
  WEFT_HD bool stopped() const { return false; }

  /// Distances in memory from a particle to its neighbours.
  struct Shifts {
    int by[neighbours];
  };
  WEFT_HD static Shifts shifts(const ClothParams<T>& cloth) {
    constexpr auto offsets = Stencil::offsets();
    Shifts s{};
    WEFT_UNROLL
    for (int k = 0; k < neighbours; ++k) {
      s.by[k] = offsets.row[k] * cloth.columns + offsets.column[k];
    }
    return s;
  }

  /// Sets `force` to the sum of the spring forces.
  template <int N>
  WEFT_HD void gather(const ClothParams<T>& cloth, const ParticleBuffers<T>& p, int block, int i0,
                      Lanes<N> lanes, LaneVec3<T, N>& force) const {
    const Shifts shift = shifts(cloth);
    if (inner[block]) {
      lanes.each([&](int l) WEFT_LANE {
        const Vec3<T> here = load(p.x_in, i0 + l);
        Vec3<T> sum{T(0), T(0), T(0)};
        WEFT_UNROLL
        for (int k = 0; k < neighbours; ++k) {
          const Vec3<T> to = load(p.x_in, i0 + l + shift.by[k]) - here;
          sum = sum + spring_force(to, cloth.stiffness[k], cloth.rest[k]);
        }
        force.set(l, sum);
      });
    } else {
      lanes.each([&](int l) WEFT_LANE {
        const Vec3<T> here = load(p.x_in, i0 + l);
        const int bits = presence[i0 + l];
        Vec3<T> sum{T(0), T(0), T(0)};
        WEFT_UNROLL
        for (int k = 0; k < neighbours; ++k) {
          const Vec3<T> there = load(p.x_in, i0 + l + shift.by[k]);
          const Vec3<T> to = select((bits >> k) & 1, there, here) - here;
          sum = sum + spring_force(to, cloth.stiffness[k], cloth.rest[k]);
        }
        force.set(l, sum);
      });
    }
  }

  /// Adds the damping along the springs to `force`; velocities are displacements * per_dt.
  template <bool Position, int N>
  WEFT_HD void damp(const ClothParams<T>& cloth, const ParticleBuffers<T>& p, T per_dt,
                    int /*block*/, int i0, Lanes<N> lanes, LaneVec3<T, N>& force) const {
    const Shifts shift = shifts(cloth);
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> here = load(p.x_in, i0 + l);
      const Vec3<T> moved = displacement<Position>(p, i0 + l);
      const int bits = presence[i0 + l];
      Vec3<T> sum = force.get(l);
      WEFT_UNROLL
      for (int k = 0; k < neighbours; ++k) {
        const int j = i0 + l + shift.by[k];
        const Vec3<T> to = select((bits >> k) & 1, load(p.x_in, j), here) - here;
        const Vec3<T> velocity = per_dt * (displacement<Position>(p, j) - moved);
        sum = sum + spring_damping_force(to, velocity, cloth.spring_damping);
      }
      force.set(l, sum);
    });
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
