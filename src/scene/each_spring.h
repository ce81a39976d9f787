// The springs of a fabric one by one, each once, in a fixed order.
#pragma once

#include "scene/fabric.h"
#include "scene/grid.h"

namespace weft::scene {

/// Calls use(i, j, stiffness, rest length) for the springs from the vertices [first, end); a rest
/// length below 0 means that of the rest shape.
template <class Use>
void each_spring(const CookedFabric& fabric, uint32_t first, uint32_t end, Use use) {
  if (fabric.is_grid) {
    const CookedGrid& g = fabric.grid;
    const StencilTable& table = stencil_table(g.stencil);
    for (uint32_t v = first; v < end; ++v) {
      const int64_t row = v / g.columns, column = v % g.columns;
      for (int k = table.count / 2; k < table.count; ++k) {
        const StencilOffset o = table.offset[k];
        if (!has_neighbour(g, row, column, o)) continue;
        const auto j = static_cast<uint32_t>((row + o.row) * g.columns + column + o.column);
        use(v, j, stencil_stiffness(o, fabric.stiffness), fabric.rest_length);
      }
    }
    return;
  }
  const SpringRows& rows = fabric.rows;
  for (uint32_t v = first; v < end; ++v) {
    for (uint64_t e = rows.start[v]; e < rows.start[size_t(v) + 1]; ++e) {
      if (rows.neighbour[e] < v) continue;
      use(v, rows.neighbour[e],
          rows.stiffness.empty() ? fabric.stiffness.stretch : rows.stiffness[e],
          rows.rest.empty() ? fabric.rest_length : rows.rest[e]);
    }
  }
}
/// For all of them.
template <class Use>
void each_spring(const CookedFabric& fabric, Use use) {
  each_spring(fabric, 0, fabric.vertices, use);
}

}  // namespace weft::scene
