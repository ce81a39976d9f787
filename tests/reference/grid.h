// Grid sheets, written from the description of the stencils: positions, springs and counts.
#pragma once

#include "reference/springs.h"

#include <utility>

namespace reference {

using Offsets = std::vector<std::pair<int, int>>;  // (row, column), one of each opposite pair

inline Offsets seed12() { return {{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 2}, {2, -2}}; }
inline Offsets classic12() { return {{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 0}, {0, 2}}; }
inline Offsets quad4() { return {{1, 0}, {0, 1}}; }
inline Offsets tri6() { return {{1, 0}, {0, 1}, {1, 1}}; }

/// Vertex r*columns + c at (c width/(columns-1), r height/(rows-1), 0).
inline std::vector<Vec> grid_positions(uint32_t rows, uint32_t columns, double width = 1,
                                       double height = 1) {
  std::vector<Vec> x;
  for (uint32_t r = 0; r < rows; ++r)
    for (uint32_t c = 0; c < columns; ++c)
      x.push_back({columns > 1 ? c * width / (columns - 1) : 0.0,
                   rows > 1 ? r * height / (rows - 1) : 0.0, 0.0});
  return x;
}

/// Undirected springs of the grid with rest length 0.
inline std::vector<Spring> grid_springs(uint32_t rows, uint32_t columns, const Offsets& offsets,
                                        double stiffness) {
  std::vector<Spring> springs;
  for (int r = 0; r < int(rows); ++r)
    for (int c = 0; c < int(columns); ++c)
      for (const auto& [dr, dc] : offsets) {
        const int row = r + dr, column = c + dc;
        if (row < 0 || row >= int(rows) || column < 0 || column >= int(columns)) continue;
        springs.push_back({uint32_t(r) * columns + uint32_t(c),
                           uint32_t(row) * columns + uint32_t(column), stiffness, 0});
      }
  return springs;
}

/// Undirected springs whose rest length is the distance in `x`.
inline std::vector<Spring> grid_springs_at_rest(uint32_t rows, uint32_t columns,
                                                const Offsets& offsets, double stiffness,
                                                const std::vector<Vec>& x) {
  std::vector<Spring> springs = grid_springs(rows, columns, offsets, stiffness);
  rest_at(x, springs);
  return springs;
}

}  // namespace reference
