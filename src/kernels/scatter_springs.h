// Spring forces of a cloth whose springs have been evaluated once each (kernels/edge_forces.h).
#pragma once

#include "kernels/hubs.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Native: forces are summed where they are needed, to the bits of the gather. Otherwise the sums
/// are there already, and are emptied for the atomics of the next substep.
template <class T, template <class> class FanOfCloth>
struct ScatterSprings {
  using Fan = FanOfCloth<T>;
  Edges<T> edges;
  Hubs<T> hubs;

  static constexpr bool uneven = true;
  static constexpr bool projected = false;
  WEFT_HD int64_t work_before(int first_block, int count) const {
    return edges.accumulation == Accumulation::native ? incident_before(edges, first_block, count)
                                                      : int64_t(count);
  }
  /// Nothing moves any more once a force has left the range of the integers.
  WEFT_HD bool stopped() const {
    return edges.overflow != nullptr && *edges.overflow != no_overflow;
  }

  template <int N>
  WEFT_HD void gather(const ClothParams<T>& cloth, const ParticleBuffers<T>& /*p*/, int block,
                      int i0, Lanes<N> lanes, LaneVec3<T, N>& force) const {
    if (edges.accumulation != Accumulation::native) return take(cloth, i0, lanes, force);
    lanes.each([&](int l) WEFT_LANE { force.set(l, {T(0), T(0), T(0)}); });
    sum_incident(edges, edges.force, block, i0, lanes, force);
    if (hubs.of_block != nullptr) {
      add_hubs(hubs, hubs.force, block, i0, lanes, force);
    }
  }

  template <bool Position, int N>
  WEFT_HD void damp(const ClothParams<T>& /*cloth*/, const ParticleBuffers<T>& /*p*/, T /*per_dt*/,
                    int block, int i0, Lanes<N> lanes, LaneVec3<T, N>& force) const {
    if (edges.damping.data == nullptr) return;
    sum_incident(edges, edges.damping, block, i0, lanes, force);
    if (hubs.of_block != nullptr) {
      add_hubs(hubs, hubs.damping, block, i0, lanes, force);
    }
  }

 private:
  template <int N>
  WEFT_HD_COLD void take(const ClothParams<T>& cloth, int i0, Lanes<N> lanes,
                         LaneVec3<T, N>& force) const {
    const int t0 = i0 - edges.first_block * block_size;
    if (edges.accumulation == Accumulation::fixed64) {
      const T newtons = T(1) / cloth.fixed_scale;
      unsigned long long* sum = edges.fixed + 3 * int64_t(t0);
      lanes.each_alone([&](int l) {
        const Vec3<T> units{T(static_cast<long long>(sum[3 * l])),
                            T(static_cast<long long>(sum[3 * l + 1])),
                            T(static_cast<long long>(sum[3 * l + 2]))};
        force.set(l, newtons * units);
        sum[3 * l] = sum[3 * l + 1] = sum[3 * l + 2] = 0;
      });
      return;
    }
    lanes.each([&](int l) WEFT_LANE {
      force.set(l, load(edges.total, t0 + l));
      store(edges.total, t0 + l, Vec3<T>{T(0), T(0), T(0)});
    });
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
