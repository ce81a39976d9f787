// Colliders of triangles below the cloths: open and closed, in every way. Made with + - * / and
// square roots only, so that every compiler makes the same.
#pragma once

#include "samples/effects/collider_effects.h"

namespace weft::samples {

struct Surface {
  std::vector<double3> positions;
  std::vector<uint32_t> triangles;
  bool closed = false;
};

constexpr double pi = 3.141592653589793;
inline double sine(double x) {
  while (x > pi) x -= 2 * pi;
  while (x < -pi) x += 2 * pi;
  double sum = 0;
  for (int k = 27; k > 1; k -= 2) sum = (1 - sum) * x * x / (k * (k - 1));
  return (1 - sum) * x;
}

/// A ball of 2 x rings quads around, whose upper side may be dented. Closed, its poles are one
/// vertex each.
inline Surface ball(double radius, uint32_t rings, bool closed, double dent) {
  Surface ball;
  ball.closed = closed;
  const uint32_t around = 2 * rings;
  for (uint32_t r = 0; r <= rings; ++r) {
    for (uint32_t a = 0; a < around; ++a) {
      const double t = pi * r / rings, p = 2 * pi * a / around;
      const double out = radius * sine(t), z = radius * sine(t + pi / 2);
      const double w = out * out / (radius * radius);
      const double sunk = z > 0 ? dent * radius / (1 + 4 * w + 8 * w * w) : 0;
      ball.positions.push_back({out * sine(p + pi / 2), out * sine(p), z - sunk});
    }
  }
  const auto vertex = [&](uint32_t r, uint32_t a) {
    const bool pole = closed && (r == 0 || r == rings);
    return r * around + (pole ? 0 : a % around);
  };
  const auto triangle = [&](uint32_t a, uint32_t b, uint32_t c) {
    if (a != b && b != c && c != a) ball.triangles.insert(ball.triangles.end(), {a, b, c});
  };
  for (uint32_t r = 0; r < rings; ++r) {
    for (uint32_t a = 0; a < around; ++a) {
      triangle(vertex(r, a), vertex(r + 1, a), vertex(r + 1, a + 1));
      triangle(vertex(r, a), vertex(r + 1, a + 1), vertex(r, a + 1));
    }
  }
  return ball;
}

inline Surface waves(double side, uint32_t n, double height) {
  Surface sheet;
  for (uint32_t v = 0; v < (n + 1) * (n + 1); ++v) {
    const double x = double(v % (n + 1)) / n - 0.5, y = double(v / (n + 1)) / n - 0.5;
    sheet.positions.push_back({side * x, side * y, height * sine(9 * x) * sine(7 * y + 1.87)});
  }
  for (uint32_t v = 0; v < n * (n + 1); ++v) {
    if (v % (n + 1) == n) continue;
    const uint32_t a = v, b = v + 1, c = v + n + 1, d = c + 1;
    sheet.triangles.insert(sheet.triangles.end(), {a, b, d, a, d, c});
  }
  return sheet;
}

inline MeshColliderDesc cooked(Stage& s, const Surface& surface, double thickness, double3 at) {
  ColliderMeshDesc desc;
  desc.positions = View<double3>(surface.positions);
  desc.indices = surface.triangles;
  desc.thickness = thickness;
  desc.closed = surface.closed;
  MeshColliderDesc collider;
  collider.mesh = take(s.context.cook(desc));
  collider.pose.translate = at;
  return collider;
}
inline void add(Stage& s, const MeshColliderDesc& d) {
  s.colliders.push_back(take(s.world.create_mesh(d)));
}

/// The sheets that are timed lie on the top of an open ball.
inline MeshColliderDesc open_mesh(Stage& s, double depth) {
  return cooked(s, ball(0.4, s.fine ? 132 : 10, false, 0), 0.005, {0.5, 0.5, -0.405 - depth});
}
inline MeshColliderDesc closed_mesh(Stage& s, double depth) {
  return cooked(s, ball(0.3, 8, true, 0.3), 0.01, {0.5, 0.5, -0.25 - depth});
}

template <auto mesh, Way way>
void put_mesh(Stage& s) {
  MeshColliderDesc collider = mesh(s, 0);
  go(collider, way);
  add(s, collider);
}
template <auto mesh>
void put_mesh_far(Stage& s) {
  add(s, mesh(s, far_away));
}
/// A closed one and a standing sheet, one beside the other.
template <Way way>
void put_both_meshes(Stage& s) {
  MeshColliderDesc closed = cooked(s, ball(0.2, 8, true, 0.3), 0.01, {0.25, 0.5, -0.22});
  MeshColliderDesc sheet = cooked(s, waves(0.5, 6, 0.05), 0.01, {0.7, 0.5, -0.22});
  sheet.pose.degrees = 60;
  for (MeshColliderDesc* mesh : {&closed, &sheet}) {
    go(*mesh, way);
    add(s, *mesh);
  }
}
template <auto mesh, Way way>
constexpr Effect mesh_collider(const char* name) {
  return {.name = name,
          .used = {.furnish = put_mesh<mesh, way>, .lead = way == Way::turning ? turn : nullptr}};
}
inline constexpr Effect on_open_mesh{
    .name = "open_mesh",
    .used = {.line = "mesh of 69,696 triangles, used", .furnish = put_mesh<open_mesh, Way::smooth>},
    .null = {
        {.line = "mesh of 69,696 triangles, out of reach", .furnish = put_mesh_far<open_mesh>}}};
inline constexpr Effect on_closed_mesh{
    .name = "closed_mesh",
    .used = {.line = "closed mesh, used", .furnish = put_mesh<closed_mesh, Way::smooth>},
    .null = {{.furnish = put_mesh_far<closed_mesh>}}};

inline constexpr Effect mesh_effects[] = {
    {.name = "both_meshes_rough", .used = {.furnish = put_both_meshes<Way::rough>}},
    {.name = "both_meshes_moving", .used = {.furnish = put_both_meshes<Way::moving>}},
    {.name = "both_meshes_turning",
     .used = {.furnish = put_both_meshes<Way::turning>, .lead = turn}},
    on_open_mesh,
    mesh_collider<open_mesh, Way::rough>("open_mesh_rough"),
    mesh_collider<open_mesh, Way::moving>("open_mesh_moving"),
    mesh_collider<open_mesh, Way::turning>("open_mesh_turning"),
    on_closed_mesh,
    mesh_collider<closed_mesh, Way::rough>("closed_mesh_rough"),
    mesh_collider<closed_mesh, Way::moving>("closed_mesh_moving"),
    mesh_collider<closed_mesh, Way::turning>("closed_mesh_turning")};

}  // namespace weft::samples
