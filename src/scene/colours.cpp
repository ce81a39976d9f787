#include "scene/colours.h"

#include <algorithm>
#include <bit>

#include "scene/grid.h"

namespace weft::scene {

namespace {

constexpr int32_t block_springs = 32;

/// Colours of a grid: for each direction (dr, dc) the springs that begin in rows with floor(r / dr)
/// even, then odd; along a row the same of columns.
class GridColours {
 public:
  explicit GridColours(const CookedFabric& fabric)
      : fabric_(fabric),
        rows_(static_cast<int32_t>(fabric.grid.rows)),
        columns_(static_cast<int32_t>(fabric.grid.columns)) {
    out_.start.push_back(0);
  }

  Colours colour(const Ladder& ladder) {
    const StencilTable& table = stencil_table(fabric_.grid.stencil);
    for (const uint8_t stride : ladder.stride) {
      if (stride == 0) break;
      for (int k = table.count / 2; k < table.count; ++k) {
        if (is_stretch(table.offset[k])) direction(table.offset[k], k, stride);
      }
    }
    for (const auto wanted : {is_bend, is_shear, is_stretch}) {
      for (int k = table.count / 2; k < table.count; ++k) {
        if (wanted(table.offset[k])) direction(table.offset[k], k, 1);
      }
    }
    return std::move(out_);
  }

 private:
  static int32_t size(int32_t v) { return v < 0 ? -v : v; }
  static bool is_bend(const StencilOffset& o) { return std::max(size(o.row), size(o.column)) == 2; }
  static bool is_shear(const StencilOffset& o) { return size(o.row) == 1 && size(o.column) == 1; }
  static bool is_stretch(const StencilOffset& o) { return size(o.row) + size(o.column) == 1; }

  void direction(const StencilOffset& o, int slot, uint8_t stride) {
    if (stencil_stiffness(o, fabric_.stiffness) == 0 && stride > 1) return;
    out_.longest = std::max(out_.longest, stride);
    const int32_t dr = o.row * stride, dc = o.column * stride;
    block_ = {0, dr * columns_ + dc, static_cast<uint8_t>(slot), 1, 0, stride};
    for (int32_t parity = 0; parity < 2; ++parity) {
      if (dr > 0) {
        for (int32_t row = parity * dr; row + dr < rows_; ++row) {
          if (row / dr % 2 == parity) across(row, dc);
        }
      } else {
        for (int32_t row = 0; row < rows_; ++row) along(row, dc, parity);
      }
      if (out_.blocks.size() > out_.start.back()) {
        out_.start.push_back(static_cast<uint32_t>(out_.blocks.size()));
        out_.rows_up.push_back(dr);
      }
    }
  }

  /// The springs from a row to another one: a strand.
  void across(int32_t row, int32_t dc) {
    const int32_t begin = std::max(0, -dc), end = columns_ - std::max(0, dc);
    strand(row * columns_ + begin, end - begin, 1);
  }
  /// Those of a parity within a row.
  void along(int32_t row, int32_t dc, int32_t parity) {
    const int32_t row0 = row * columns_;
    const int32_t begin = parity * dc;
    if (dc == 1) return strand(row0 + begin, (columns_ - begin) / 2, 2);
    if (dc == 2) {
      const int32_t fours = std::max(0, columns_ - begin) / 4;
      strand(row0 + begin, fours, 4);
      const int32_t rest = begin + 4 * fours;
      return strand(row0 + rest, std::max(0, columns_ - rest - 2), 1);
    }
    for (int32_t c = begin; c + dc < columns_; c += 2 * dc) {
      strand(row0 + c, std::min(dc, columns_ - c - dc), 1);
    }
  }
  void strand(int32_t first, int32_t count, uint8_t step) {
    for (; count > 0; count -= block_springs, first += step * block_springs) {
      ColourBlock block = block_;
      block.first = first;
      block.step = step;
      block.count = static_cast<uint8_t>(std::min(count, block_springs));
      out_.blocks.push_back(block);
    }
  }

  const CookedFabric& fabric_;
  int32_t rows_, columns_;
  ColourBlock block_{};
  Colours out_;
};

/// The colours that the springs of a vertex have: bit k of word k / 64.
struct Taken {
  uint64_t word[most_colours / 64] = {};
};

uint32_t first_free(const Taken& a, const Taken& b) {
  for (uint32_t w = 0; w < most_colours / 64; ++w) {
    const uint64_t both = a.word[w] | b.word[w];
    if (both != ~uint64_t(0)) return 64 * w + static_cast<uint32_t>(std::countr_one(both));
  }
  return most_colours;
}

Colours colour_list(const CookedFabric& fabric) {
  Colours out;
  for (uint32_t v = 0; v < fabric.vertices; ++v) {
    const uint64_t springs = fabric.rows.start[size_t(v) + 1] - fabric.rows.start[v];
    // Two ends of so many springs leave a colour free.
    if (2 * springs <= most_colours || springs <= out.valence) continue;
    out.most_at = v;
    out.valence = static_cast<uint32_t>(springs);
  }
  out.start.push_back(0);
  if (out.valence > 0) return out;
  const Edges table = build_edges(fabric);
  Vector<Taken> taken(fabric.vertices);
  Vector<uint8_t> colour(table.edges.size());
  Vector<uint32_t> sizes;
  for (size_t e = 0; e < table.edges.size(); ++e) {
    Taken &a = taken[table.edges[e].a], &b = taken[table.edges[e].b];
    const uint32_t c = first_free(a, b);
    colour[e] = static_cast<uint8_t>(c);
    a.word[c / 64] |= uint64_t(1) << (c % 64);
    b.word[c / 64] |= uint64_t(1) << (c % 64);
    if (c == sizes.size()) sizes.push_back(0);
    ++sizes[c];
  }
  Vector<size_t> next;
  for (const uint32_t size : sizes) {
    const size_t first = out.springs.size();
    next.push_back(first);
    for (uint32_t at = 0; at < size; at += block_springs) {
      const uint32_t count = std::min<uint32_t>(block_springs, size - at);
      out.blocks.push_back({static_cast<int32_t>(first + at), 0, 0, 1, uint8_t(count), 1});
      out.springs.resize(out.springs.size() + block_springs, Edge{0, 0, 0});
    }
    out.start.push_back(static_cast<uint32_t>(out.blocks.size()));
  }
  for (size_t e = 0; e < table.edges.size(); ++e) out.springs[next[colour[e]]++] = table.edges[e];
  return out;
}

}  // namespace

Ladder usual_ladder(const CookedFabric& fabric) {
  Ladder ladder;
  if (!fabric.is_grid) return ladder;
  const uint32_t most = std::max(fabric.grid.rows, fabric.grid.columns);
  uint8_t stride = most < 64 ? 0 : most < 192 ? 8 : most < 448 ? 16 : 32;
  for (int k = 0; stride >= 4; stride /= 2) ladder.stride[k++] = stride;
  return ladder;
}

uint64_t ladder_springs(const Colours& colours) {
  uint64_t sum = 0;
  for (const ColourBlock& b : colours.blocks) sum += b.stride > 1 ? b.count : 0;
  return sum;
}

Colours colour_springs(const CookedFabric& fabric, const Ladder& ladder) {
  return fabric.is_grid ? GridColours(fabric).colour(ladder) : colour_list(fabric);
}

}  // namespace weft::scene
