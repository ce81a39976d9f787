// The unit forms that solids are placed copies of.
#include "render/solids.h"

#include <cmath>
#include <numbers>

namespace weft::render {
namespace {

constexpr uint32_t around = 48;  ///< corners of a circle

std::array<float, 2> on_circle(uint32_t i, uint32_t corners = around) {
  const double angle = 2 * std::numbers::pi * double(i % corners) / corners;
  return {float(std::cos(angle)), float(std::sin(angle))};
}

/// Two triangles for each cell of a grid of `rows` circles of vertices.
void add_tube(uint32_t rows, uint32_t corners, std::vector<uint32_t>& indices) {
  for (uint32_t r = 0; r + 1 < rows; ++r) {
    for (uint32_t i = 0; i < corners; ++i) {
      const uint32_t a = r * corners + i, b = r * corners + (i + 1) % corners;
      indices.insert(indices.end(), {a, b, a + corners, b, b + corners, a + corners});
    }
  }
}

void add_cap(float z, Triangles& out) {
  const auto first = uint32_t(out.vertices.size());
  out.vertices.push_back({0, 0, z, 0, 0, z});
  for (uint32_t i = 0; i < around; ++i) {
    const auto [x, y] = on_circle(i);
    out.vertices.push_back({x, y, z, 0, 0, z});
  }
  for (uint32_t i = 0; i < around; ++i) {
    const uint32_t a = first + 1 + i, b = first + 1 + (i + 1) % around;
    if (z > 0)
      out.indices.insert(out.indices.end(), {first, a, b});
    else
      out.indices.insert(out.indices.end(), {first, b, a});
  }
}

}  // namespace

Triangles capsule_form(uint32_t corners) {
  const uint32_t rings = corners / 4;  // of a half sphere
  Triangles form;
  for (uint32_t r = 0; r <= 2 * rings + 1; ++r) {
    const bool far = r > rings;
    const double turns = double(far ? r - 1 : r) / (2 * rings);
    const auto z = float(-std::cos(std::numbers::pi * turns));
    const auto wide = float(std::sin(std::numbers::pi * turns));
    for (uint32_t i = 0; i < corners; ++i) {
      const auto [x, y] = on_circle(i, corners);
      form.vertices.push_back({wide * x, wide * y, z, far ? 1.0f : 0.0f, 0, 0});
    }
  }
  add_tube(2 * rings + 2, corners, form.indices);
  return form;
}

Triangles planet_form(double finest) {
  constexpr uint32_t rings = 96, corners = 96;
  const double growth = std::pow(std::numbers::pi / finest, 1.0 / (rings - 1));
  Triangles form;
  double angle = finest;
  for (uint32_t r = 0; r <= rings; ++r, angle *= r > 1 ? growth : 1) {
    const double from_top = r == 0 ? 0 : std::min(angle, std::numbers::pi);
    const double wide = std::sin(from_top), half = std::sin(from_top / 2);
    for (uint32_t i = 0; i < corners; ++i) {
      const auto [x, y] = on_circle(i, corners);
      form.vertices.push_back({float(wide * x), float(wide * y), float(-2 * half * half),
                               float(wide * x), float(wide * y), float(1 - 2 * half * half)});
    }
  }
  add_tube(rings + 1, corners, form.indices);
  return form;
}

Triangles cylinder_form() {
  Triangles form;
  for (const float z : {-1.0f, 1.0f}) {
    for (uint32_t i = 0; i < around; ++i) {
      const auto [x, y] = on_circle(i);
      form.vertices.push_back({x, y, z, x, y, 0});
    }
  }
  add_tube(2, around, form.indices);
  add_cap(-1, form);
  add_cap(1, form);
  return form;
}

Triangles box_form() {
  Triangles form;
  for (size_t axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const auto first = uint32_t(form.vertices.size());
      for (uint32_t corner = 0; corner < 4; ++corner) {
        std::array<float, 6> v{};
        v[axis] = v[3 + axis] = side;
        v[(axis + 1) % 3] = corner & 1 ? 1.0f : -1.0f;
        v[(axis + 2) % 3] = corner & 2 ? side : -side;
        form.vertices.push_back(v);
      }
      for (const uint32_t corner : {0u, 1u, 2u, 1u, 3u, 2u}) form.indices.push_back(first + corner);
    }
  }
  return form;
}

Triangles disc_form() {
  Triangles form;
  add_cap(1, form);
  for (auto& vertex : form.vertices) vertex[2] = 0;
  return form;
}

}  // namespace weft::render
