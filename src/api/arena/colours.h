// Springs that are constraints: the blocks of all cloths by colour (state/coloured.h).
#pragma once

#include "api/arena/arena.h"

namespace weft::api {

/// Where they begin; null where springs are forces.
class ColourStarts {
 public:
  explicit ColourStarts(const ArenaInput&);
  /// Points to memory of this.
  ColourTable table() const;

 private:
  int cloths_ = 0;
  void add_sweep(const ClothRecord&, size_t cloth);

  Vector<int32_t> start_, of_, work_{0};
  Vector<ColourSweep> sweep_;
  Vector<Vector<int32_t>> lag_, row_start_;  ///< by large cloth
};
/// Writes the blocks in that order.
void fill_spring_blocks(const ArenaInput&, SpringBlock*);

}  // namespace weft::api
