// Largest eigenvalue of the stiffness of a set of springs, by power iteration.
#pragma once

#include "reference/random.h"
#include "reference/springs.h"

#include <algorithm>
#include <vector>

namespace reference {

/// Largest eigenvalue of M^-1 K, K the Laplacian of the springs: the exact limit of springs whose
/// rest length is zero, and an upper bound of the true stiffness at any deformation.
/// `inverse_mass` 0 stands for a pin.
inline double largest_laplacian_eigenvalue(const std::vector<Spring>& springs,
                                           const std::vector<double>& inverse_mass,
                                           int iterations) {
  const size_t n = inverse_mass.size();
  SplitMix random(99);
  std::vector<double> u(n), next(n);
  for (size_t i = 0; i < n; ++i) u[i] = inverse_mass[i] > 0 ? random.uniform() - 0.5 : 0;
  double value = 0;
  for (int it = 0; it < iterations; ++it) {
    for (double& e : next) e = 0;
    double energy = 0, mass = 0;
    for (const Spring& s : springs) {
      const double pull = s.stiffness * (u[s.b] - u[s.a]);
      next[s.a] -= pull;
      next[s.b] += pull;
      energy += pull * (u[s.b] - u[s.a]);
    }
    double norm = 0;
    for (size_t i = 0; i < n; ++i) {
      if (inverse_mass[i] > 0) mass += u[i] * u[i] / inverse_mass[i];
      next[i] *= inverse_mass[i];
      norm += next[i] * next[i];
    }
    value = energy / mass;  // Rayleigh quotient: never above the true value
    norm = std::sqrt(norm);
    for (size_t i = 0; i < n; ++i) u[i] = next[i] / norm;
  }
  return value;
}

/// dt <= 2/sqrt(max over the springs of S_i/m_i + S_j/m_j): the bound weft promises.
inline double edge_bound(const std::vector<Spring>& springs,
                         const std::vector<double>& inverse_mass) {
  std::vector<double> sum(inverse_mass.size(), 0.0);
  for (const Spring& s : springs) {
    sum[s.a] += s.stiffness;
    sum[s.b] += s.stiffness;
  }
  double worst = 0;
  for (const Spring& s : springs)
    worst = std::max(worst, sum[s.a] * inverse_mass[s.a] + sum[s.b] * inverse_mass[s.b]);
  return 2 / std::sqrt(worst);
}

}  // namespace reference
