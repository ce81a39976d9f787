// Finds what is near among many things with boxes.
#pragma once

#include "render/box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace weft::render {

/// At most 64 cells along each axis, with lists of the boxes that touch them.
class BoxGrid {
 public:
  BoxGrid() = default;
  /// `all` holds all boxes.
  BoxGrid(const Box& all, const std::vector<Box>& boxes);

  /// Calls `use` with the number of each box that may touch this one, of some more than once.
  template <class Use>
  void each_near(const Box& box, Use use) const {
    each_cell(cells_of(box), [&](size_t cell) {
      for (uint32_t k = start_[cell]; k < start_[cell + 1]; ++k) use(numbers_[k]);
    });
  }

 private:
  using Range = std::array<std::array<int, 2>, 3>;
  Range cells_of(const Box&) const;
  template <class Use>
  void each_cell(const Range& r, Use use) const {
    for (int k = r[2][0]; k <= r[2][1]; ++k) {
      for (int j = r[1][0]; j <= r[1][1]; ++j) {
        for (int i = r[0][0]; i <= r[0][1]; ++i) {
          use((size_t(k) * size_t(cells_[1]) + size_t(j)) * size_t(cells_[0]) + size_t(i));
        }
      }
    }
  }

  Vector3d low_{0, 0, 0};
  double cell_ = 1;
  std::array<int, 3> cells_{1, 1, 1};
  std::vector<uint32_t> start_{0, 0}, numbers_;  ///< of cell c: numbers_[start_[c]], ...
};

}  // namespace weft::render
