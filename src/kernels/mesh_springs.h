// Spring forces of a mesh or network, gathered over sliced rows (state/springs.h).
//
// Georgii and Westermann 2005, section 4.1 (point-centric approach), without padding every row to
// the largest valence: the width is a slice's own, and hubs have a pass of theirs (kernels/hubs.h).
#pragma once

#include "base/lanes.h"
#include "kernels/displacement.h"
#include "kernels/fan.h"
#include "kernels/hubs.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// `PerSpring`: stiffness is stored with every spring, otherwise it is the cloth's.
template <class T, bool PerSpring>
struct MeshSprings {
  using Fan = MeshFan<T>;
  SlicedRows<T> rows;
  Hubs<T> hubs;

  static constexpr bool uneven = true;
  static constexpr bool projected = false;
  /// Entries of `count` blocks from the first on, and as much again for each particle.
  WEFT_HD int64_t work_before(int first_block, int count) const {
    const int slice = first_block - rows.first_block;
    return rows.start[slice + count] - rows.start[slice] + int64_t(count) * block_size;
  }
  WEFT_HD bool stopped() const { return false; }

  template <int N>
  WEFT_HD void gather(const ClothParams<T>& cloth, const ParticleBuffers<T>& p, int block, int i0,
                      Lanes<N> lanes, LaneVec3<T, N>& force) const {
    lanes.each([&](int l) WEFT_LANE { force.set(l, {T(0), T(0), T(0)}); });
    const T uniform = cloth.stiffness[0];
    const int slice = block - rows.first_block;
    for (int64_t e = rows.start[slice] + (i0 - block * block_size); e < rows.start[slice + 1];
         e += block_size) {
      lanes.each([&](int l) WEFT_LANE {
        const Vec3<T> to = load(p.x_in, rows.neighbour[e + l]) - load(p.x_in, i0 + l);
        const T stiffness = PerSpring ? rows.stiffness[e + l] : uniform;
        force.set(l, force.get(l) + spring_force(to, stiffness, rows.rest[e + l]));
      });
    }
    if (hubs.of_block != nullptr) {
      add_hubs(hubs, hubs.force, block, i0, lanes, force);
    }
  }

  template <bool Position, int N>
  WEFT_HD void damp(const ClothParams<T>& cloth, const ParticleBuffers<T>& p, T per_dt, int block,
                    int i0, Lanes<N> lanes, LaneVec3<T, N>& force) const {
    const int slice = block - rows.first_block;
    for (int64_t e = rows.start[slice] + (i0 - block * block_size); e < rows.start[slice + 1];
         e += block_size) {
      lanes.each([&](int l) WEFT_LANE {
        const int j = rows.neighbour[e + l];
        const Vec3<T> to = load(p.x_in, j) - load(p.x_in, i0 + l);
        const Vec3<T> velocity =
            per_dt * (displacement<Position>(p, j) - displacement<Position>(p, i0 + l));
        force.set(l, force.get(l) + spring_damping_force(to, velocity, cloth.spring_damping));
      });
    }
    if (hubs.of_block != nullptr) {
      add_hubs(hubs, hubs.damping, block, i0, lanes, force);
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
