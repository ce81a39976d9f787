// Which of a cloth's near colliders each block can touch in the coming frame (state/activity.h).
#pragma once

#include "base/lanes.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Whether a box has a point in common with what a collider sweeps through.
template <class T>
WEFT_HD bool can_touch(Vec3<T> low, Vec3<T> high, const ColliderBounds<T>& c) {
  const T none = T(0);
  const Vec3<T> apart{larger(none, larger(c.low.x - high.x, low.x - c.high.x)),
                      larger(none, larger(c.low.y - high.y, low.y - c.high.y)),
                      larger(none, larger(c.low.z - high.z, low.z - c.high.z))};
  const bool near = dot(apart, apart) <= c.radius2;
  const Vec3<T> lowest{c.normal.x > T(0) ? low.x : high.x, c.normal.y > T(0) ? low.y : high.y,
                       c.normal.z > T(0) ? low.z : high.z};
  const bool below = dot(c.normal, lowest) <= c.offset;
  return near & below;
}

template <class T>
struct ReachOfBlocks {
  Simulation<T> sim;
  Vec3Array<T> x;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const ClothActivity<T>& activity = sim.activity[sim.block.cloth[block]];
    if (activity.nearness != Nearness::block) return;
    const int i0 = block * block_size + lane0;
    LaneVec3<T, N> least, most;
    const int last = sim.cloths[sim.block.cloth[block]].end - 1;
    lanes.each([&](int l) WEFT_LANE {
      const int i = i0 + l < last ? i0 + l : last;
      least.set(l, load(x, i));
      most.set(l, load(x, i));
    });
    const T m = activity.margin;
    BlockReach<T> reach{};
    reach.low = {smallest_of_lanes(least.x, lanes) - m, smallest_of_lanes(least.y, lanes) - m,
                 smallest_of_lanes(least.z, lanes) - m};
    reach.high = {largest_of_lanes(most.x, lanes) + m, largest_of_lanes(most.y, lanes) + m,
                  largest_of_lanes(most.z, lanes) + m};
    if (lane0 != 0) return;
    const int first = activity.near_first[0], end = activity.near_end[collider_shapes - 1];
    for (int j = first; j < end && j < first + 64; ++j) {
      if (can_touch(reach.low, reach.high, sim.colliders.near_bounds[j])) {
        reach.mask |= uint64_t(1) << (j - first);
      }
    }
    sim.reach[block] = reach;
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
