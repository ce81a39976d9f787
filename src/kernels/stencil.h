// Neighbours of a grid particle. Offsets stand in ascending (row, column) order, which is ascending
// index order for whatever neighbours exist; presence bit k belongs to offset k.
#pragma once

#include "base/portability.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <int K>
struct Offsets {
  int8_t row[K], column[K];
};

/// Fratarcangeli 2011, figure 22.2.
struct Seed12 {
  static constexpr int neighbours = 12;
  WEFT_HD static constexpr Offsets<12> offsets() {
    return {{-2, -2, -1, -1, -1, 0, 0, 1, 1, 1, 2, 2}, {-2, 2, -1, 0, 1, -1, 1, -1, 0, 1, -2, 2}};
  }
};
/// Bend springs along the axes instead of the diagonals.
struct Classic12 {
  static constexpr int neighbours = 12;
  WEFT_HD static constexpr Offsets<12> offsets() {
    return {{-2, -1, -1, -1, 0, 0, 0, 0, 1, 1, 1, 2}, {0, -1, 0, 1, -2, -1, 1, 2, -1, 0, 1, 0}};
  }
};
struct Quad4 {
  static constexpr int neighbours = 4;
  WEFT_HD static constexpr Offsets<4> offsets() { return {{-1, 0, 0, 1}, {0, -1, 1, 0}}; }
};
/// The regular triangulation of Georgii and Westermann's measurements.
struct Tri6 {
  static constexpr int neighbours = 6;
  WEFT_HD static constexpr Offsets<6> offsets() {
    return {{-1, -1, 0, 0, 1, 1}, {-1, 0, -1, 1, 0, 1}};
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
