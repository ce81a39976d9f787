#include "scene/energy.h"

#include <algorithm>
#include <cmath>

#include "scene/each_spring.h"

namespace weft::scene {

static double length_between(const double3& a, const double3& b) {
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return std::sqrt(x * x + y * y + z * z);
}

namespace {

struct Lengthening {
  double rest, longer;  // m
  double strain(double hair) const { return rest > hair ? longer / rest : 0; }
};

Lengthening lengthening(const EnergyInput& in, uint32_t i, uint32_t j, double rest) {
  const double l0 = rest >= 0 ? rest : length_between(in.rest_shape[i], in.rest_shape[j]);
  return {l0, length_between(in.x[i], in.x[j]) - l0};
}

/// m: springs between vertices in one place, as at the poles of a globe, have a rest length of
/// rounding errors, and no stretch to speak of.
double least_rest(const EnergyInput& in) {
  double longest = 0;
  each_spring(in.fabric, [&](uint32_t i, uint32_t j, double, double rest) {
    longest = std::max(longest, lengthening(in, i, j, rest).rest);
  });
  return 1e-9 * longest;
}

double largest_edge_strain(const EnergyInput& in, double hair) {
  const Array<uint32_t>& corners = in.fabric.triangles;
  double most = 0;
  for (size_t t = 0; t < corners.size(); t += 3) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t i = corners[t + k], j = corners[t + (k + 1) % 3];
      most = std::max(most, lengthening(in, i, j, in.fabric.rest_length).strain(hair));
    }
  }
  return most;
}

}  // namespace

Energies energies(const EnergyInput& in) {
  Energies sum;
  const CookedFabric& fabric = in.fabric;
  const bool edges = !fabric.triangles.empty();
  const double hair = least_rest(in);
  if (edges) sum.stretch = largest_edge_strain(in, hair);
  each_spring(fabric, [&](uint32_t i, uint32_t j, double stiffness, double rest) {
    const Lengthening spring = lengthening(in, i, j, rest);
    sum.elastic += 0.5 * stiffness * spring.longer * spring.longer;
    if (edges || (fabric.is_grid && are_two_apart(fabric.grid, i, j))) return;
    sum.stretch = std::max(sum.stretch, spring.strain(hair));
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
