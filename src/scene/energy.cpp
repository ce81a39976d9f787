#include "scene/energy.h"

#include <cmath>

#include "scene/grid.h"

namespace weft::scene {

static double distance(const double3& a, const double3& b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return std::sqrt(x * x + y * y + z * z);
}

static double spring_energy(const EnergyInput& in, uint32_t i, uint32_t j, double stiffness,
                            double rest) {
  const double l0 = rest >= 0 ? rest : distance(in.rest_shape[i], in.rest_shape[j]);
  const double stretch = distance(in.x[i], in.x[j]) - l0;
  return 0.5 * stiffness * stretch * stretch;
}

static double grid_elastic(const EnergyInput& in) {
  const GridShape& g = in.fabric.grid;
  const StencilTable& table = stencil_table(g.stencil);
  double sum = 0;
  for (uint32_t v = 0; v < in.fabric.vertices; ++v) {
    const int64_t row = v / g.columns, column = v % g.columns;
    for (int k = table.count / 2; k < table.count; ++k) {
      const StencilOffset o = table.offset[k];
      if (!has_neighbour(g, row, column, o)) continue;
      const auto j = static_cast<uint32_t>((row + o.row) * g.columns + column + o.column);
      sum +=
          spring_energy(in, v, j, stencil_stiffness(o, in.fabric.stiffness), in.fabric.rest_length);
    }
  }
  return sum;
}

static double rows_elastic(const EnergyInput& in) {
  const SpringRows& rows = in.fabric.rows;
  double sum = 0;
  for (uint32_t v = 0; v < in.fabric.vertices; ++v) {
    for (uint64_t e = rows.start[v]; e < rows.start[size_t(v) + 1]; ++e) {
      if (rows.neighbour[e] < v) continue;
      const double k = rows.stiffness.empty() ? in.fabric.stiffness.stretch : rows.stiffness[e];
      const double rest = rows.rest.empty() ? in.fabric.rest_length : rows.rest[e];
      sum += spring_energy(in, v, rows.neighbour[e], k, rest);
    }
  }
  return sum;
}

Energies energies(const EnergyInput& in) {
  Energies sum;
  sum.elastic = in.fabric.is_grid ? grid_elastic(in) : rows_elastic(in);
  for (uint32_t i = 0; i < in.fabric.vertices; ++i) {
    if (in.pinned && (*in.pinned)[i]) continue;
    const double m = in.fabric.mass_of(i);
    if (std::isinf(m)) continue;  // as a pin
    const double3 &v = in.v[i], &x = in.x[i], &g = in.gravity;
    sum.kinetic += 0.5 * m * (v.x * v.x + v.y * v.y + v.z * v.z);
    sum.potential -= m * (g.x * x.x + g.y * x.y + g.z * x.z);
    sum.momentum = {sum.momentum.x + m * v.x, sum.momentum.y + m * v.y, sum.momentum.z + m * v.z};
  }
  return sum;
}

}  // namespace weft::scene
