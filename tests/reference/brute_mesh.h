// Distance to a triangle mesh by looking at every triangle; nothing here comes from weft.
#pragma once

#include "reference/vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace reference {

struct Triangles {
  std::vector<Vec> vertices;
  std::vector<std::array<uint32_t, 3>> faces;
};

inline Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec nearest_on_segment(Vec a, Vec b, Vec x) {
  const Vec edge = b - a;
  const double along = dot(x - a, edge) / dot(edge, edge);
  return a + std::fmin(1, std::fmax(0, along)) * edge;
}
/// The foot on the plane if it is in the triangle, else the nearest point of the three edges.
inline Vec nearest_on_triangle(Vec a, Vec b, Vec c, Vec x) {
  const Vec n = cross(b - a, c - a);
  const Vec foot = x - (dot(n, x - a) / dot(n, n)) * n;
  if (dot(n, cross(b - a, foot - a)) >= 0 && dot(n, cross(c - b, foot - b)) >= 0 &&
      dot(n, cross(a - c, foot - c)) >= 0) {
    return foot;
  }
  Vec best = nearest_on_segment(a, b, x);
  for (const Vec p : {nearest_on_segment(b, c, x), nearest_on_segment(c, a, x)}) {
    if (length(x - p) < length(x - best)) best = p;
  }
  return best;
}
inline Vec nearest_on_mesh(const Triangles& mesh, Vec x) {
  Vec best{1e300, 0, 0};
  for (const auto& f : mesh.faces) {
    const Vec p =
        nearest_on_triangle(mesh.vertices[f[0]], mesh.vertices[f[1]], mesh.vertices[f[2]], x);
    if (length(x - p) < length(x - best)) best = p;
  }
  return best;
}
inline double distance_to_mesh(const Triangles& mesh, Vec x) {
  return length(x - nearest_on_mesh(mesh, x));
}

/// Whether a closed mesh winds around x: the solid angles of its triangles (van Oosterom & Strackee
/// 1983) add up to the whole sphere or to nothing.
inline bool is_inside(const Triangles& mesh, Vec x) {
  double angle = 0;
  for (const auto& f : mesh.faces) {
    const Vec a = mesh.vertices[f[0]] - x, b = mesh.vertices[f[1]] - x, c = mesh.vertices[f[2]] - x;
    const double la = length(a), lb = length(b), lc = length(c);
    const double below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
    angle += 2 * std::atan2(dot(a, cross(b, c)), below);
  }
  return angle > 6.28;
}

/// Whether the segment from p to q goes through a triangle.
inline bool crosses(const Triangles& mesh, Vec p, Vec q) {
  for (const auto& f : mesh.faces) {
    const Vec a = mesh.vertices[f[0]], b = mesh.vertices[f[1]], c = mesh.vertices[f[2]];
    const Vec n = cross(b - a, c - a);
    const double before = dot(n, p - a), after = dot(n, q - a);
    if ((before > 0) == (after > 0)) continue;
    const Vec x = p + (before / (before - after)) * (q - p);
    if (dot(n, cross(b - a, x - a)) >= 0 && dot(n, cross(c - b, x - b)) >= 0 &&
        dot(n, cross(a - c, x - c)) >= 0) {
      return true;
    }
  }
  return false;
}

}  // namespace reference
