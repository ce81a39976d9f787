#include <algorithm>
#include <numeric>

#include "base/stable_sort_host.h"
#include "scene/rows.h"

namespace weft::scene {

uint32_t build_rows(const Vector<SpringRecord>& springs, CookedFabric& fabric) {
  SpringRows& rows = fabric.rows;
  fabric.springs = springs.size();
  rows.start.assign(size_t(fabric.vertices) + 1, 0);
  bool own_stiffness = false, own_rest = false;
  for (const SpringRecord& s : springs) {
    ++rows.start[size_t(s.a) + 1];
    ++rows.start[size_t(s.b) + 1];
    own_stiffness |= s.stiffness >= 0 && s.stiffness != fabric.stiffness.stretch;
    own_rest |= s.rest >= 0;
  }
  std::partial_sum(rows.start.begin(), rows.start.end(), rows.start.begin());

  struct RowEntry {
    uint32_t neighbour, spring;
  };
  Vector<RowEntry> entries(2 * springs.size());
  Vector<uint64_t> next(rows.start.begin(), rows.start.end());
  for (uint32_t s = 0; s < springs.size(); ++s) {
    entries[next[springs[s].a]++] = {springs[s].b, s};
    entries[next[springs[s].b]++] = {springs[s].a, s};
  }
  for (uint32_t v = 0; v < fabric.vertices; ++v) {
    std::sort(entries.begin() + static_cast<std::ptrdiff_t>(rows.start[v]),
              entries.begin() + static_cast<std::ptrdiff_t>(rows.start[size_t(v) + 1]),
              [](RowEntry x, RowEntry y) { return x.neighbour < y.neighbour; });
  }

  rows.neighbour.resize(entries.size());
  if (own_stiffness) rows.stiffness.resize(entries.size());
  if (own_rest) rows.rest.resize(entries.size());
  for (size_t e = 0; e < entries.size(); ++e) {
    const SpringRecord& s = springs[entries[e].spring];
    rows.neighbour[e] = entries[e].neighbour;
    if (own_stiffness)
      rows.stiffness[e] = s.stiffness >= 0 ? s.stiffness : fabric.stiffness.stretch;
    if (own_rest) rows.rest[e] = s.rest >= 0 ? s.rest : fabric.rest_length;
  }
  return order_rows(fabric);
}

/// Returns how many pieces that springs join there are.
static uint32_t breadth_first(const CookedFabric& fabric, Array<uint32_t>& order) {
  uint32_t pieces = 0;
  const SpringRows& rows = fabric.rows;
  Vector<bool> seen(fabric.vertices, false);
  order.clear();
  order.reserve(fabric.vertices);
  for (uint32_t root = 0; root < fabric.vertices; ++root) {
    if (seen[root]) continue;
    seen[root] = true;
    size_t head = order.size();
    order.push_back(root);
    for (; head < order.size(); ++head) {
      const uint32_t v = order[head];
      for (uint64_t e = rows.start[v]; e < rows.start[size_t(v) + 1]; ++e) {
        const uint32_t n = rows.neighbour[e];
        if (seen[n]) continue;
        seen[n] = true;
        order.push_back(n);
      }
    }
    pieces += rows.start[root] < rows.start[size_t(root) + 1];
  }
  return pieces;
}

/// Width that a row takes of its slice.
static uint64_t sliced_width(const SpringRows& rows, uint32_t v) {
  const uint64_t valence = rows.start[size_t(v) + 1] - rows.start[v];
  return valence > hub_valence ? 0 : valence;
}

static void slice(CookedFabric& fabric) {
  const SpringRows& rows = fabric.rows;
  const Array<uint32_t>& order = fabric.caller_of;
  const uint32_t slices = (fabric.vertices + block_size - 1) / block_size;
  fabric.slice_start.assign(size_t(slices) + 1, 0);
  for (uint32_t slice = 0; slice < slices; ++slice) {
    uint64_t width = 0;
    const uint32_t end = std::min(fabric.vertices, (slice + 1) * uint32_t(block_size));
    for (uint32_t s = slice * uint32_t(block_size); s < end; ++s) {
      width = std::max(width, sliced_width(rows, order[s]));
    }
    fabric.slice_start[size_t(slice) + 1] =
        fabric.slice_start[slice] + static_cast<int64_t>(width) * block_size;
  }
  fabric.row_entries = fabric.slice_start.back();
  for (uint32_t s = 0; s < fabric.vertices; ++s) {
    const uint64_t valence = rows.start[size_t(order[s]) + 1] - rows.start[order[s]];
    if (valence <= hub_valence) continue;
    fabric.hubs.push_back({s, fabric.row_entries, static_cast<uint32_t>(valence)});
    fabric.row_entries +=
        static_cast<int64_t>((valence + block_size - 1) / block_size * block_size);
  }
}

uint32_t order_rows(CookedFabric& fabric) {
  constexpr size_t window = 1024;
  Array<uint32_t>& order = fabric.caller_of;
  const uint32_t pieces = breadth_first(fabric, order);
  for (size_t first = 0; first < order.size(); first += window) {
    const size_t end = std::min(first + window, order.size());
    weft::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(first),
                      order.begin() + static_cast<std::ptrdiff_t>(end),
                      [&](uint32_t a, uint32_t b) {
                        return sliced_width(fabric.rows, a) > sliced_width(fabric.rows, b);
                      });
  }
  fabric.storage_of.resize(fabric.vertices);
  for (uint32_t s = 0; s < fabric.vertices; ++s) fabric.storage_of[order[s]] = s;
  slice(fabric);
  return pieces;
}

}  // namespace weft::scene
