// Wind on triangles in double precision, from the formula of scene-format.md.
#pragma once

#include "reference/brute_mesh.h"

#include <algorithm>

namespace reference {

struct Air {
  Vec velocity;
  double density = 1.225, normal = 1, tangential = 0.02;
};

/// Forces on the vertices, and the force per relative velocity by which a step could overshoot.
struct WindForces {
  std::vector<Vec> force;
  std::vector<double> conductance;
};

inline WindForces wind_forces(const Triangles& mesh, const std::vector<Vec>& v, const Air& air) {
  WindForces out{std::vector<Vec>(mesh.vertices.size()),
                 std::vector<double>(mesh.vertices.size(), 0)};
  for (const auto& [i, j, k] : mesh.faces) {
    const Vec a = mesh.vertices[i], n2 = cross(mesh.vertices[j] - a, mesh.vertices[k] - a);
    const double area = length(n2) / 2;
    if (!(area > 0)) continue;
    const Vec n = (1 / length(n2)) * n2, u = air.velocity - (1.0 / 3) * (v[i] + v[j] + v[k]);
    const double across = dot(u, n);
    const Vec along = u - across * n;
    const double half = air.density * area / 2;
    const Vec force = half * (air.normal * std::abs(across) * across * n +
                              air.tangential * length(along) * along);
    const double most =
        half * std::max(air.normal * std::abs(across), air.tangential * length(along));
    for (const uint32_t vertex : {i, j, k}) {
      out.force[vertex] += (1.0 / 3) * force;
      out.conductance[vertex] += most / 3;
    }
  }
  return out;
}

}  // namespace reference
