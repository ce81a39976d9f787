#include "scene/edges.h"

#include <algorithm>

#include "scene/grid.h"

namespace weft::scene {

namespace {

/// The springs of one vertex after the other, neighbours ascending in the caller's order.
struct Rows {
  Vector<uint64_t> start;  ///< by caller index, and one more
  Vector<uint32_t> neighbour;
  Vector<uint8_t> stencil;  ///< grids: which neighbour of the stencil
};

Rows rows_of_grid(const CookedFabric& fabric) {
  const StencilTable& table = stencil_table(fabric.grid.stencil);
  Rows rows;
  rows.start.reserve(size_t(fabric.vertices) + 1);
  rows.neighbour.reserve(2 * fabric.springs);
  rows.stencil.reserve(2 * fabric.springs);
  rows.start.push_back(0);
  for (uint32_t v = 0; v < fabric.vertices; ++v) {
    const int64_t row = v / fabric.grid.columns, column = v % fabric.grid.columns;
    for (int k = 0; k < table.count; ++k) {
      const StencilOffset o = table.offset[k];
      if (!has_neighbour(fabric.grid, row, column, o)) continue;
      rows.neighbour.push_back(
          static_cast<uint32_t>((row + o.row) * fabric.grid.columns + column + o.column));
      rows.stencil.push_back(static_cast<uint8_t>(k));
    }
    rows.start.push_back(rows.neighbour.size());
  }
  return rows;
}

Rows rows_of(const CookedFabric& fabric) {
  if (fabric.is_grid) return rows_of_grid(fabric);
  return {{fabric.rows.start.begin(), fabric.rows.start.end()},
          {fabric.rows.neighbour.begin(), fabric.rows.neighbour.end()},
          {}};
}

uint32_t caller_of(const CookedFabric& fabric, uint32_t storage) {
  return fabric.is_grid ? storage : fabric.caller_of[storage];
}

Vector<int64_t> slices_of_grid(const CookedFabric& fabric) {
  const StencilTable& table = stencil_table(fabric.grid.stencil);
  Vector<int64_t> start{0};
  int width = 0;
  for (uint32_t v = 0; v < fabric.vertices; ++v) {
    const int64_t row = v / fabric.grid.columns, column = v % fabric.grid.columns;
    int valence = 0;
    for (int k = 0; k < table.count; ++k) {
      if (has_neighbour(fabric.grid, row, column, table.offset[k])) ++valence;
    }
    width = std::max(width, valence);
    if (v % block_size == block_size - 1 || v + 1 == fabric.vertices) {
      start.push_back(start.back() + int64_t(width) * block_size);
      width = 0;
    }
  }
  return start;
}

/// Where the entries of a vertex stand: the first, and from one to the next.
struct Place {
  int64_t first;
  int64_t stride;
};

class Builder {
 public:
  explicit Builder(const CookedFabric& fabric) : fabric_(fabric), rows_(rows_of(fabric)) {}

  Edges build() {
    number_edges();
    if (fabric_.is_grid) {
      out_.slice_start = slices_of_grid(fabric_);
      out_.incident.assign(size_t(out_.slice_start.back()), padding(out_));
    } else {
      out_.slice_start.assign(fabric_.slice_start.begin(), fabric_.slice_start.end());
      out_.incident.assign(size_t(fabric_.row_entries), padding(out_));
    }
    size_t hub = 0;
    for (uint32_t s = 0; s < fabric_.vertices; ++s) {
      Place at{out_.slice_start[s / block_size] + s % block_size, block_size};
      if (hub < fabric_.hubs.size() && fabric_.hubs[hub].storage == s) {
        at = {fabric_.hubs[hub++].first, 1};
      }
      list(s, at);
    }
    return std::move(out_);
  }

 private:
  /// Every spring once, at the end that is stored first.
  void number_edges() {
    edge_of_.resize(rows_.neighbour.size());
    out_.edges.reserve(fabric_.springs);
    for (uint32_t s = 0; s < fabric_.vertices; ++s) {
      const uint32_t v = caller_of(fabric_, s);
      for (uint64_t k = rows_.start[v]; k < rows_.start[size_t(v) + 1]; ++k) {
        const uint32_t other = fabric_.storage(rows_.neighbour[k]);
        if (other < s) continue;
        edge_of_[k] = static_cast<int32_t>(out_.edges.size());
        out_.edges.push_back({s, other, fabric_.is_grid ? rows_.stencil[k] : k});
      }
    }
  }

  /// The springs of the vertex that is stored at s.
  void list(uint32_t s, Place at) {
    const uint32_t v = caller_of(fabric_, s);
    for (uint64_t k = rows_.start[v]; k < rows_.start[size_t(v) + 1]; ++k, at.first += at.stride) {
      const uint32_t n = rows_.neighbour[k];
      const bool first = fabric_.storage(n) > s;
      out_.incident[size_t(at.first)] = first ? edge_of_[k] : ~edge_of_[entry_of(n, v)];
    }
  }

  /// Entry of neighbour n in the row of v.
  uint64_t entry_of(uint32_t v, uint32_t n) const {
    const auto begin = rows_.neighbour.begin() + static_cast<std::ptrdiff_t>(rows_.start[v]);
    const auto end =
        rows_.neighbour.begin() + static_cast<std::ptrdiff_t>(rows_.start[size_t(v) + 1]);
    return static_cast<uint64_t>(std::lower_bound(begin, end, n) - rows_.neighbour.begin());
  }

  const CookedFabric& fabric_;
  Rows rows_;
  Vector<int32_t> edge_of_;  ///< by entry, where the vertex is end a
  Edges out_;
};

}  // namespace

uint64_t padded_edges(uint64_t edges) {
  return (edges / uint64_t(block_size) + 1) * uint64_t(block_size);
}

int64_t incident_entries(const CookedFabric& fabric) {
  return fabric.is_grid ? slices_of_grid(fabric).back() : fabric.row_entries;
}

Edges build_edges(const CookedFabric& fabric) { return Builder(fabric).build(); }

}  // namespace weft::scene
