// What is told of springs that are stretched beyond reason.
#include <cmath>

#include "api/world/state.h"

namespace weft {
inline namespace v0 {

Status World::Impl::tell_of_stretch() {
  const Status status = arena->watch_stretch(*built);
  if (status != Status::ok) return status;
  const auto tell = [&](EventType type, ClothId cloth, uint32_t vertex, const Text& words) {
    events.push_back({type, cloth, vertex, time, nullptr}, words);
  };
  for (api::ClothRecord* cloth : built->cloths) {
    if (cloth->asleep) continue;
    api::StretchWatch& watch = cloth->stretch;
    const scene::Stretches now = watch.now;
    const bool beyond = now.largest > api::large_stretch;
    watch.beyond |= beyond;
    if (beyond && !watch.told_stretch) {
      watch.told_stretch = true;
      tell(EventType::large_stretch, cloth->id, now.a,
           text("the spring %u-%u of cloth %u is %.6g m long (its rest length is %.6g m, and more "
                "than 10 times that beyond it is no cloth) start without overlaps, move pins and "
                "colliders slower, or lower `safety`",
                now.a, now.b, cloth->id.index, now.length, now.rest));
    }
    watch.now = {};
    if (watch.next < scene::stretch_items(cloth->cooked())) continue;
    watch.told_stretch = watch.beyond;
    const double mean =
        watch.rest_squares > 0 ? std::sqrt(watch.longer_squares / watch.rest_squares) : 0;
    const bool much = mean > api::large_mean_stretch;
    if (much && !watch.told_energy) {
      tell(EventType::energy_growth, cloth->id, 0,
           text("the springs of cloth %u are stretched by %.3g times their rest length on average "
                "(more than 2: it gains energy from nothing) lower `safety`, give it damping, or "
                "start without overlaps",
                cloth->id.index, mean));
    }
    watch.told_energy = much;
    watch.next = 0;
    watch.beyond = false;
    watch.longer_squares = watch.rest_squares = 0;
  }
  return Status::ok;
}

}  // namespace v0
}  // namespace weft
