#include "api/arena/colours.h"

#include <algorithm>

#include "scene/colours.h"

namespace weft::api {

ColourStarts::ColourStarts(const ArenaInput& in) : cloths_(static_cast<int>(in.cloths.size())) {
  if (!in.shape.projects) return;
  uint32_t colours = 0;
  for (const ClothRecord* cloth : in.cloths) colours = std::max(colours, cloth->colours->count());
  int32_t at = 0;
  for (uint32_t c = 0; c < colours; ++c) {
    start_.push_back(at);
    for (const ClothRecord* cloth : in.cloths) {
      const scene::Colours& own = *cloth->colours;
      of_.push_back(at);
      if (c < own.count()) at += static_cast<int32_t>(own.start[c + 1] - own.start[c]);
    }
    of_.push_back(at);
  }
  start_.push_back(at);
  for (const ClothRecord* cloth : in.cloths) {
    add_sweep(*cloth, work_.size() - 1);
    work_.push_back(work_.back() + static_cast<int32_t>(cloth->colours->blocks.size()));
  }
}

/// A grid of more particles than the cache of a core holds between two colours.
constexpr uint32_t large_grid = 32768;

void ColourStarts::add_sweep(const ClothRecord& cloth, size_t index) {
  const scene::CookedFabric& fabric = cloth.cooked();
  const scene::Colours& own = *cloth.colours;
  sweep_.push_back({});
  if (!fabric.is_grid || fabric.vertices < large_grid || own.count() == 0) return;
  const auto rows = static_cast<int32_t>(fabric.grid.rows);
  const auto columns = static_cast<int32_t>(fabric.grid.columns);
  Vector<int32_t> lag, row_start;
  int32_t behind = 0;
  for (uint32_t c = 0; c < own.count(); ++c) {
    behind += c > 0 ? own.rows_up[c] : 0;
    lag.push_back(behind);
    const int32_t first = of_[c * (static_cast<size_t>(cloths_) + 1) + index];
    uint32_t block = own.start[c];
    for (int32_t row = 0; row <= rows; ++row) {
      while (block < own.start[c + 1] && own.blocks[block].first < row * columns) ++block;
      row_start.push_back(first + static_cast<int32_t>(block - own.start[c]));
    }
  }
  lag_.push_back(std::move(lag));
  row_start_.push_back(std::move(row_start));
  sweep_.back() = {rows, static_cast<int32_t>(own.count()), lag_.back().data(),
                   row_start_.back().data()};
}

ColourTable ColourStarts::table() const {
  if (start_.empty()) return {};
  int32_t most = 0;
  for (size_t k = 1; k < work_.size(); ++k) most = std::max(most, work_[k] - work_[k - 1]);
  return {static_cast<int32_t>(start_.size()) - 1,
          cloths_,
          start_.data(),
          of_.data(),
          work_.data(),
          sweep_.data(),
          most};
}

void fill_spring_blocks(const ArenaInput& in, SpringBlock* out) {
  const ColourStarts starts(in);
  const ColourTable table = starts.table();
  Vector<int32_t> next(table.start, table.start + table.colours);
  for (const ClothRecord* cloth : in.cloths) {
    const scene::Colours& own = *cloth->colours;
    const int32_t shift = cloth->cooked().is_grid
                              ? cloth->first()
                              : static_cast<int32_t>(cloth->place.coloured_springs);
    for (uint32_t c = 0; c < own.count(); ++c) {
      for (uint32_t b = own.start[c]; b < own.start[c + 1]; ++b) {
        const scene::ColourBlock& block = own.blocks[b];
        out[next[c]++] = {static_cast<int32_t>(cloth->place.cloths),
                          shift + block.first,
                          block.shift,
                          block.slot,
                          block.step,
                          block.count,
                          block.stride};
      }
    }
  }
}

}  // namespace weft::api
