#include "scene/grid.h"

#include <cstdlib>

#include "base/message_host.h"
#include "scene/check.h"

namespace weft::scene {

const StencilTable& stencil_table(Stencil stencil) {
  static const StencilTable seed12{12,
                                   {{-2, -2},
                                    {-2, 2},
                                    {-1, -1},
                                    {-1, 0},
                                    {-1, 1},
                                    {0, -1},
                                    {0, 1},
                                    {1, -1},
                                    {1, 0},
                                    {1, 1},
                                    {2, -2},
                                    {2, 2}}};
  static const StencilTable classic12{12,
                                      {{-2, 0},
                                       {-1, -1},
                                       {-1, 0},
                                       {-1, 1},
                                       {0, -2},
                                       {0, -1},
                                       {0, 1},
                                       {0, 2},
                                       {1, -1},
                                       {1, 0},
                                       {1, 1},
                                       {2, 0}}};
  static const StencilTable quad4{4, {{-1, 0}, {0, -1}, {0, 1}, {1, 0}}};
  static const StencilTable tri6{6, {{-1, -1}, {-1, 0}, {0, -1}, {0, 1}, {1, 0}, {1, 1}}};
  switch (stencil) {
    case Stencil::seed12:
      return seed12;
    case Stencil::classic12:
      return classic12;
    case Stencil::quad4:
      return quad4;
    case Stencil::tri6:
      return tri6;
  }
  throw InvalidInput(text(
      "stencil %d (it is none of seed12, classic12, quad4, tri6) give one of them", int(stencil)));
}

int stencil_radius(Stencil stencil) {
  return stencil == Stencil::seed12 || stencil == Stencil::classic12 ? 2 : 1;
}

double stencil_stiffness(StencilOffset o, const Stiffness& stiffness) {
  if (std::abs(o.row) == 2 || std::abs(o.column) == 2) return stiffness.bend;
  return o.row != 0 && o.column != 0 ? stiffness.shear : stiffness.stretch;
}

static uint64_t spring_count(const CookedGrid& g) {
  const StencilTable& table = stencil_table(g.stencil);
  uint64_t directed = 0;
  for (int k = 0; k < table.count; ++k) {
    const auto r = static_cast<uint64_t>(std::abs(table.offset[k].row));
    const auto c = static_cast<uint64_t>(std::abs(table.offset[k].column));
    if (g.rows > r && g.columns > c) directed += (g.rows - r) * (g.columns - c);
  }
  return directed / 2;
}

void cook_grid(const GridDesc& desc, CookedFabric& fabric) {
  if (desc.rows < 1 || desc.columns < 1) {
    throw InvalidInput(
        text("grid of %u x %u (a grid needs at least one row and one column) give "
             "rows and columns >= 1",
             desc.rows, desc.columns));
  }
  const uint64_t vertices = uint64_t(desc.rows) * desc.columns;
  if (vertices > (uint64_t(1) << 30)) {
    throw InvalidInput(
        text("grid of %u x %u (a fabric has at most 2^30 vertices) use fewer rows or "
             "columns",
             desc.rows, desc.columns));
  }
  check_positive(desc.width, "width");
  check_positive(desc.height, "height");
  stencil_table(desc.stencil);
  check_material(desc.material, static_cast<uint32_t>(vertices));
  const double scale = desc.material.scale;
  if (desc.width * scale > largest_coordinate || desc.height * scale > largest_coordinate) {
    throw InvalidInput(
        text("grid of %g m x %g m (coordinates must stay within 1e9 m) make it smaller",
             desc.width * scale, desc.height * scale));
  }
  fabric.is_grid = true;
  fabric.vertices = static_cast<uint32_t>(vertices);
  fabric.stiffness = desc.material.stiffness;
  fabric.rest_length = desc.material.rest_length;
  fabric.grid.rows = desc.rows;
  fabric.grid.columns = desc.columns;
  fabric.grid.stencil = desc.stencil;
  fabric.grid.row_spacing = desc.rows > 1 ? desc.height * scale / (desc.rows - 1) : 0;
  fabric.grid.column_spacing = desc.columns > 1 ? desc.width * scale / (desc.columns - 1) : 0;
  fabric.springs = spring_count(fabric.grid);
  set_masses(desc.material.mass, fabric);
}

uint64_t triangle_count(const CookedFabric& fabric) {
  if (!fabric.is_grid) return fabric.triangles.size() / 3;
  return uint64_t(fabric.grid.rows - 1) * (fabric.grid.columns - 1) * 2;
}

void triangle(const CookedFabric& fabric, uint64_t t, uint32_t* out) {
  if (!fabric.is_grid) {
    for (int c = 0; c < 3; ++c) out[c] = fabric.triangles[3 * t + static_cast<uint64_t>(c)];
    return;
  }
  const uint32_t columns = fabric.grid.columns;
  const uint64_t quad = t / 2;
  const auto a = static_cast<uint32_t>(quad / (columns - 1) * columns + quad % (columns - 1));
  const uint32_t b = a + 1, c = a + columns, d = a + columns + 1;
  out[0] = a;
  out[1] = t % 2 == 0 ? b : d;
  out[2] = t % 2 == 0 ? d : c;
}

}  // namespace weft::scene
