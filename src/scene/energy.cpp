#include "scene/energy.h"

#include <algorithm>
#include <cmath>

#include "scene/each_spring.h"

namespace weft::scene {

static double distance(const double3& a, const double3& b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return std::sqrt(x * x + y * y + z * z);
}

static void add_spring(const EnergyInput& in, uint32_t i, uint32_t j, double stiffness, double rest,
                       Energies& sum) {
  const double l0 = rest >= 0 ? rest : distance(in.rest_shape[i], in.rest_shape[j]);
  const double longer = distance(in.x[i], in.x[j]) - l0;
  sum.elastic += 0.5 * stiffness * longer * longer;
  if (l0 > 0) sum.stretch = std::max(sum.stretch, longer / l0);
}

Energies energies(const EnergyInput& in) {
  Energies sum;
  each_spring(in.fabric, [&](uint32_t i, uint32_t j, double stiffness, double rest) {
    add_spring(in, i, j, stiffness, rest, sum);
  });
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
