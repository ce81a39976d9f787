// Stencils of a grid on the host: offsets, classes, rest lengths, spring counts.
#pragma once

#include "scene/fabric.h"

namespace weft::scene {

struct StencilOffset {
  int row, column;
};
/// Offsets in the order of kernels/stencil.h: ascending (row, column).
struct StencilTable {
  int count;
  StencilOffset offset[12];
};
const StencilTable& stencil_table(Stencil);
/// How far a stencil goes along rows or columns.
int stencil_radius(Stencil);
/// Stiffness of a neighbour: axial stretch, diagonal shear, two apart bend.
double stencil_stiffness(StencilOffset, const Stiffness&);

/// Whether neighbour `o` of vertex (row, column) exists.
inline bool has_neighbour(const CookedGrid& g, int64_t row, int64_t column, StencilOffset o) {
  const int64_t r = row + o.row, c = column + o.column;
  return r >= 0 && c >= 0 && r < g.rows && c < g.columns;
}

/// Whether vertices i and j stand two rows or columns apart, as the ends of bend springs do.
inline bool are_two_apart(const CookedGrid& g, uint32_t i, uint32_t j) {
  const int64_t rows = int64_t(j / g.columns) - int64_t(i / g.columns);
  const int64_t columns = int64_t(j % g.columns) - int64_t(i % g.columns);
  return rows * rows == 4 || columns * columns == 4;
}

}  // namespace weft::scene
