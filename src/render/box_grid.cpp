#include "render/box_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace weft::render {

BoxGrid::BoxGrid(const Box& all, const std::vector<Box>& boxes) : low_(all.low) {
  if (boxes.empty()) return;
  constexpr double most_cells = 64;
  const Vector3d size = all.high - all.low;
  cell_ = std::max(size.maxCoeff() / most_cells, 1e-300);
  size_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int cells = int(std::min(size[axis] / cell_, most_cells - 1)) + 1;
    cells_[size_t(axis)] = cells;
    count *= size_t(cells);
  }
  start_.assign(count + 1, 0);
  for (const Box& box : boxes) {
    each_cell(cells_of(box), [&](size_t cell) { ++start_[cell + 1]; });
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  numbers_.resize(start_.back());
  std::vector<uint32_t> next(start_.begin(), start_.end() - 1);
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    each_cell(cells_of(boxes[i]), [&](size_t cell) { numbers_[next[cell]++] = i; });
  }
}

// Boxes end in the last cell, also where rounding says beyond; what lies outside of all has none.
BoxGrid::Range BoxGrid::cells_of(const Box& box) const {
  Range range;
  for (int axis = 0; axis < 3; ++axis) {
    const double last = cells_[size_t(axis)] - 1;
    const double from = std::floor((box.low[axis] - low_[axis]) / cell_);
    const double to = std::floor((box.high[axis] - low_[axis]) / cell_);
    if (to < 0 || from > last + 1) return {{{0, -1}, {0, -1}, {0, -1}}};
    range[size_t(axis)] = {int(std::clamp(from, 0.0, last)), int(std::clamp(to, 0.0, last))};
  }
  return range;
}

}  // namespace weft::render
