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
    work_.push_back(work_.back() + static_cast<int32_t>(cloth->colours->blocks.size()));
  }
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
