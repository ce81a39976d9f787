// The region that a block's list of colliders is made for (state/activity.h), looked at while the
// new positions are still in registers: there it is nearly free, in a loop of its own it would cost
// as much as a collider.
#pragma once

#include "base/lanes.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// No limits: nothing is looked at.
struct Everywhere {
  template <int N, class Move>
  WEFT_HD bool any_outside(Lanes<N> lanes, Move move) const {
    lanes.each([&](int l) WEFT_LANE { move(l); });
    return false;
  }
};

template <class T>
struct Region {
  Vec3<T> low, high;
  int count;  ///< lanes of this call that are particles; what fills up the block stays behind

  /// Moves every lane; true if any new position is outside, or is not finite. What fills up a block
  /// counts: `is_full` tells whether there is any.
  template <int N, class Move>
  WEFT_HD bool any_outside(Lanes<N> lanes, Move move) const {
    return lanes.any([&](int l) WEFT_LANE { return is_outside(move(l)); });
  }
  template <int N, class Position>
  WEFT_HD bool any_particle_outside(Lanes<N> lanes, Position position) const {
    return lanes.any([&](int l) WEFT_LANE { return (l < count) & is_outside(position(l)); });
  }
  template <int N>
  WEFT_HD bool is_full(Lanes<N>) const {
    return count >= N;
  }
  WEFT_HD bool is_outside(Vec3<T> x) const {
    const bool in_x = (x.x >= low.x) & (x.x <= high.x);
    const bool in_y = (x.y >= low.y) & (x.y <= high.y);
    const bool in_z = (x.z >= low.z) & (x.z <= high.z);
    return !(in_x & in_y & in_z);
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
