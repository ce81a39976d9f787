// Looks at a few springs of every cloth after a frame (StretchWatch): so few that it costs nothing
// beside the substeps.
#pragma once

#include "api/arena/arena.h"
#include "base/view.h"

namespace weft::api {

template <class T>
class SpringWatcher {
 public:
  /// Where the host can read the positions `x` of the device.
  Status look_at(ClothRecord& cloth, const Vec3Array<T>& x, size_t stride) {
    const uint64_t items = scene::stretch_items(cloth.cooked());
    const uint64_t count = std::min<uint64_t>(1024, std::max<uint64_t>(32, items / 16));
    look(cloth, count, x.data + size_t(cloth.first()) * stride, stride, x.pitch);
    return Status::ok;
  }

  /// What must be fetched first is looked at as a whole, and rarely: whether it is time.
  bool is_due() {
    if (++frames_ < 64) return false;
    frames_ = 0;
    return true;
  }
  template <class Fetch>
  Status look_at_all(ClothRecord& cloth, Fetch fetch) {
    const Status status = fetch(fetched_);
    if (status != Status::ok || fetched_.empty()) return status;
    look(cloth, scene::stretch_items(cloth.cooked()), &fetched_[0].x, 3, 1);
    return status;
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

  std::vector<Vec3<T>> fetched_;
  int frames_ = 0;
};

}  // namespace weft::api
