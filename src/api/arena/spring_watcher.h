// Looks at a few springs of every cloth after a frame (StretchWatch): so few that it costs nothing
// beside the substeps.
#pragma once

#include "api/arena/arena.h"
#include "base/view.h"

namespace weft::api {

template <class T>
class SpringWatcher {
 public:
  /// At the positions that the host can read on the device; null: `fetch` reads those of a cloth.
  /// What must be fetched first is looked at as a whole, and rarely.
  template <class Fetch>
  Status look(const ArenaInput& in, const Vec3Array<T>* x, size_t stride, Fetch fetch) {
    if (!x && ++frames_ < 64) return Status::ok;
    frames_ = 0;
    for (ClothRecord* cloth : in.cloths) {
      if (cloth->asleep) continue;
      const uint64_t items = scene::stretch_items(cloth->cooked());
      if (x) {
        const uint64_t count = std::min<uint64_t>(1024, std::max<uint64_t>(32, items / 16));
        look(*cloth, count, x->data + size_t(cloth->first()) * stride, stride, x->pitch);
        continue;
      }
      const Status status = fetch(*cloth, fetched_);
      if (status != Status::ok) return status;
      if (!fetched_.empty()) look(*cloth, items, &fetched_[0].x, 3, 1);
    }
    return Status::ok;
  }

 private:
  /// Component c of the particle at storage index s is from[s * stride + c * pitch].
  static void look(ClothRecord& cloth, uint64_t count, const T* from, size_t stride, size_t pitch) {
    StretchWatch& watch = cloth.stretch;
    const scene::CookedFabric& fabric = cloth.cooked();
    if (watch.hair < 0) watch.hair = scene::least_rest(fabric);
    const uint64_t end = std::min(scene::stretch_items(fabric), watch.next + count);
    const auto position = [&](uint32_t v) {
      const T* p = from + fabric.storage(v) * stride;
      return double3{p[0], p[pitch], p[2 * pitch]};
    };
    watch.now = {};
    scene::add_stretches(fabric, watch.next, end, watch.hair, position, watch.now);
    watch.longer_squares += watch.now.longer_squares;
    watch.rest_squares += watch.now.rest_squares;
    watch.next = end;
  }

  Vector<Vec3<T>> fetched_;
  int frames_ = 0;
};

}  // namespace weft::api
