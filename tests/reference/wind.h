// Wind on triangles in double precision, from the formula of scene-format.md, and how a sheet moves
// in it (Runge-Kutta).
#pragma once

#include "reference/brute_mesh.h"

#include "reference/springs.h"

#include <algorithm>

namespace reference {

struct Air {
  Vec velocity;
  double density = 1.225, normal = 1, tangential = 0.02;
};

/// Rows of a matrix.
struct Matrix {
  Vec row[3];
};

/// Forces on the vertices, and the matrices K with which a triangle's force is K u.
struct WindForces {
  std::vector<Vec> force;
  std::vector<Matrix> per_velocity;
};

inline WindForces wind_forces(const Triangles& mesh, const std::vector<Vec>& v, const Air& air) {
  WindForces out{std::vector<Vec>(mesh.vertices.size()), std::vector<Matrix>(mesh.vertices.size())};
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
    const double b_across = half * air.normal * std::abs(across) / 3;
    const double b_along = half * air.tangential * length(along) / 3;
    const Vec unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const uint32_t vertex : {i, j, k}) {
      out.force[vertex] += (1.0 / 3) * force;
      for (int r = 0; r < 3; ++r) {
        const Vec through = dot(unit[r], n) * n;
        out.per_velocity[vertex].row[r] += b_across * through + b_along * (unit[r] - through);
      }
    }
  }
  return out;
}

/// y with (1 + s K) y = q, by Cramer's rule.
inline Vec relaxed(const Matrix& k, double s, Vec q) {
  const Vec a = Vec{1, 0, 0} + s * k.row[0], b = Vec{0, 1, 0} + s * k.row[1],
            c = Vec{0, 0, 1} + s * k.row[2];
  // The matrix is symmetric: its rows are its columns.
  const double determinant = dot(a, cross(b, c));
  return (1 / determinant) * Vec{dot(q, cross(b, c)), dot(a, cross(q, c)), dot(a, cross(b, q))};
}

/// A sheet with springs in wind.
struct WindySheet {
  Triangles mesh;
  std::vector<Vec> velocities;
  std::vector<Spring> springs;
  std::vector<double> masses;
  std::vector<bool> pinned;
  Air air;
  Vec gravity;

  std::vector<Vec> accelerations(const std::vector<Vec>& x, const std::vector<Vec>& v) const {
    std::vector<Vec> f = wind_forces({x, mesh.faces}, v, air).force;
    add_spring_forces(springs, x, f);
    for (size_t i = 0; i < f.size(); ++i)
      f[i] = pinned[i] ? Vec{} : (1 / masses[i]) * f[i] + gravity;
    return f;
  }

  /// Positions after `time`, by the classical method of order 4.
  std::vector<Vec> after(double time, int steps) const {
    const auto plus = [](std::vector<Vec> a, double s, const std::vector<Vec>& b) {
      for (size_t i = 0; i < a.size(); ++i) a[i] += s * b[i];
      return a;
    };
    const double h = time / steps;
    std::vector<Vec> x = mesh.vertices, v = velocities;
    v.resize(x.size());
    for (int n = 0; n < steps; ++n) {
      const std::vector<Vec> a1 = accelerations(x, v), v2 = plus(v, h / 2, a1);
      const std::vector<Vec> a2 = accelerations(plus(x, h / 2, v), v2), v3 = plus(v, h / 2, a2);
      const std::vector<Vec> a3 = accelerations(plus(x, h / 2, v2), v3), v4 = plus(v, h, a3);
      const std::vector<Vec> a4 = accelerations(plus(x, h, v3), v4);
      for (size_t i = 0; i < x.size(); ++i) {
        x[i] += (h / 6) * (v[i] + 2 * v2[i] + 2 * v3[i] + v4[i]);
        v[i] += (h / 6) * (a1[i] + 2 * a2[i] + 2 * a3[i] + a4[i]);
      }
    }
    return x;
  }
};

}  // namespace reference
