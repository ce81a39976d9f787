#include "scene/fan.h"

#include <algorithm>

namespace weft::scene {

/// Entries per slice: 32 times the most triangles that meet in one of its vertices.
static Vector<int64_t> slice_starts(const CookedFabric& fabric, Vector<int32_t>& count) {
  count.assign(fabric.vertices, 0);
  for (const uint32_t v : fabric.triangles) ++count[fabric.storage_of[v]];
  const size_t slices = (size_t(fabric.vertices) + block_size - 1) / block_size;
  Vector<int64_t> start(slices + 1, 0);
  for (size_t s = 0; s < slices; ++s) {
    const auto first = count.begin() + static_cast<std::ptrdiff_t>(s * block_size);
    const size_t rows = std::min<size_t>(block_size, fabric.vertices - s * block_size);
    const int32_t width = *std::max_element(first, first + static_cast<std::ptrdiff_t>(rows));
    start[s + 1] = start[s] + int64_t(width) * block_size;
  }
  return start;
}

int64_t fan_entries(const CookedFabric& fabric) {
  if (fabric.is_grid || fabric.triangles.empty()) return 0;
  Vector<int32_t> count;
  return slice_starts(fabric, count).back();
}

Fans build_fans(const CookedFabric& fabric) {
  Fans fans;
  Vector<int32_t> count;
  fans.slice_start = slice_starts(fabric, count);
  const auto entries = static_cast<size_t>(fans.slice_start.back());
  fans.next.resize(entries);
  fans.last.resize(entries);
  for (size_t s = 0; s + 1 < fans.slice_start.size(); ++s) {
    for (int64_t e = fans.slice_start[s]; e < fans.slice_start[s + 1]; ++e) {
      const auto self = static_cast<int32_t>(s * block_size + size_t(e % block_size));
      fans.next[size_t(e)] = fans.last[size_t(e)] = self;
    }
  }
  std::fill(count.begin(), count.end(), 0);
  for (size_t t = 0; t + 2 < fabric.triangles.size(); t += 3) {
    for (size_t c = 0; c < 3; ++c) {
      const uint32_t at = fabric.storage_of[fabric.triangles[t + c]];
      const auto e = static_cast<size_t>(fans.slice_start[at / block_size] +
                                         int64_t(count[at]++) * block_size + at % block_size);
      fans.next[e] = static_cast<int32_t>(fabric.storage_of[fabric.triangles[t + (c + 1) % 3]]);
      fans.last[e] = static_cast<int32_t>(fabric.storage_of[fabric.triangles[t + (c + 2) % 3]]);
    }
  }
  return fans;
}

}  // namespace weft::scene
