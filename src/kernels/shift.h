// Moves the origin that a cloth's positions are relative to.
#pragma once

#include "base/lanes.h"
#include "state/vertices.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// x -= by. With `by` in whole metres nothing is rounded where |x| does not grow.
template <class T>
struct ShiftOrigin {
  OriginJob<T> job;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const OriginJob<T> j = job;
    const int i0 = block * block_size + lane0;
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> x = load(j.x, i0 + l);
      store(j.x, i0 + l, select(i0 + l < j.particles, x - j.by, x));  // padding stays
    });
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
