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
/// How far a stencil reaches along rows or columns.
int stencil_reach(Stencil);
/// Stiffness of a neighbour: axial stretch, diagonal shear, two apart bend.
double stencil_stiffness(StencilOffset, const Stiffness&);

/// Whether neighbour `o` of vertex (row, column) exists.
inline bool has_neighbour(const GridShape& g, int64_t row, int64_t column, StencilOffset o) {
  const int64_t r = row + o.row, c = column + o.column;
  return r >= 0 && c >= 0 && r < g.rows && c < g.columns;
}

}  // namespace weft::scene
