// Triangle meshes made by rule.
#pragma once

#include "reference/brute_mesh.h"

#include <algorithm>
#include <map>

namespace reference {

/// Of two triangles per side, outward.
inline Triangles box(Vec half) {
  Triangles mesh;
  for (int v = 0; v < 8; ++v) {
    mesh.vertices.push_back(
        {v & 1 ? half.x : -half.x, v & 2 ? half.y : -half.y, v & 4 ? half.z : -half.z});
  }
  mesh.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Every triangle becomes four.
inline Triangles divided(const Triangles& mesh) {
  Triangles fine;
  fine.vertices = mesh.vertices;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
  const auto middle = [&](uint32_t a, uint32_t b) {
    const auto [at, fresh] =
        middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(fine.vertices.size()));
    if (fresh) fine.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
    return at->second;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.faces.insert(fine.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return fine;
}

/// A divided icosahedron; `dent` pulls one side in, so that it is not convex.
inline Triangles ball(double radius, int divisions, double dent = 0) {
  const double g = 0.5 * (1 + std::sqrt(5));
  Triangles mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int i = 0; i < divisions; ++i) {
    mesh = divided(mesh);
    for (Vec& v : mesh.vertices) v = (radius / length(v)) * v;
  }
  for (Vec& v : mesh.vertices) {
    const double across = (v.x * v.x + v.y * v.y) / (radius * radius);
    if (v.z > 0) v.z -= dent * radius * std::exp(-4 * across);
  }
  return mesh;
}

/// A square sheet of 2 n^2 triangles with waves along x and y.
inline Triangles sheet(double side, uint32_t n, double height) {
  Triangles mesh;
  for (uint32_t j = 0; j <= n; ++j) {
    for (uint32_t i = 0; i <= n; ++i) {
      const double x = side * (double(i) / n - 0.5), y = side * (double(j) / n - 0.5);
      mesh.vertices.push_back(
          {x, y, height * std::sin(9 * x / side) * std::cos(7 * y / side + 0.3)});
    }
  }
  for (uint32_t j = 0; j < n; ++j) {
    for (uint32_t i = 0; i < n; ++i) {
      const uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.faces.insert(mesh.faces.end(), {{a, b, d}, {a, d, c}});
    }
  }
  return mesh;
}

}  // namespace reference
