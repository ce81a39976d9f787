// Springs, their forces and energy in the plainest form: one loop over a list, double precision.
#pragma once

#include "reference/vec.h"

#include <cstdint>
#include <vector>

namespace reference {

struct Spring {
  uint32_t a, b;
  double stiffness, rest;
};

/// Adds the force of every spring: on a, k (l - l0)/l (x_b - x_a), and its opposite on b.
/// A spring of length zero pulls nothing.
inline void add_spring_forces(const std::vector<Spring>& springs, const std::vector<Vec>& x,
                              std::vector<Vec>& force) {
  for (const Spring& s : springs) {
    const Vec along = x[s.b] - x[s.a];
    const double l = length(along);
    if (l == 0) continue;
    const Vec f = (s.stiffness * (l - s.rest) / l) * along;
    force[s.a] += f;
    force[s.b] -= f;
  }
}

/// -b (relative velocity along the spring) on each end.
inline void add_spring_damping(const std::vector<Spring>& springs, double damping,
                               const std::vector<Vec>& x, const std::vector<Vec>& v,
                               std::vector<Vec>& force) {
  for (const Spring& s : springs) {
    const Vec along = x[s.b] - x[s.a];
    const double l2 = dot(along, along);
    if (l2 == 0) continue;
    const Vec f = (damping * dot(v[s.b] - v[s.a], along) / l2) * along;
    force[s.a] += f;
    force[s.b] -= f;
  }
}

inline double elastic_energy(const std::vector<Spring>& springs, const std::vector<Vec>& x) {
  double sum = 0;
  for (const Spring& s : springs) {
    const double stretch = length(x[s.b] - x[s.a]) - s.rest;
    sum += 0.5 * s.stiffness * stretch * stretch;
  }
  return sum;
}

/// All springs of `x` get their present length as rest length.
inline void rest_at(const std::vector<Vec>& x, std::vector<Spring>& springs) {
  for (Spring& s : springs) s.rest = length(x[s.b] - x[s.a]);
}

}  // namespace reference
