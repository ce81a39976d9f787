#include "render/weave.h"

#include "render/box.h"

#include <algorithm>
#include <cmath>

namespace weft::render {
namespace {

WeaveVertex pack(const Vector3d& at, const Vector3d& facing) {
  const Vector3f p = at.cast<float>(), n = facing.cast<float>();
  return {p.x(), p.y(), p.z(), n.x(), n.y(), n.z()};
}

void add_grid(const io::GridShape& grid, double scale, std::vector<WeaveVertex>& out) {
  const double x = scale * grid.width / std::max(1u, grid.columns - 1);
  const double y = scale * grid.height / std::max(1u, grid.rows - 1);
  for (uint32_t r = 0; r < grid.rows; ++r) {
    for (uint32_t c = 0; c < grid.columns; ++c) out.push_back(pack({c * x, r * y, 0}, {0, 0, 1}));
  }
}

void add_projected(const io::Surface& start, const io::SurfacePart& part,
                   std::vector<WeaveVertex>& out) {
  Box box;
  for (size_t i = 0; i < part.vertex_count; ++i) {
    box.add(vector(start.positions[part.first_vertex + i]));
  }
  for (size_t i = part.first_vertex; i < part.first_vertex + part.vertex_count; ++i) {
    const Vector3d normal = start.normals.empty() ? Vector3d::UnitZ() : vector(start.normals[i]);
    out.push_back(pack(vector(start.positions[i]) - box.low, normal));
  }
}

bool is_row(const io::GridShape& grid) { return grid.rows == 1 || grid.columns == 1; }

}  // namespace

std::vector<WeaveVertex> weave_vertices(const io::Scene& scene, const io::Surface& start) {
  std::vector<WeaveVertex> out;
  out.reserve(start.positions.size());
  for (size_t i = 0; i < start.parts.size(); ++i) {
    const io::ClothScene& cloth = scene.cloths[i];
    if (const auto* grid = std::get_if<io::GridShape>(&cloth.shape))
      add_grid(*grid, cloth.scale, out);
    else
      add_projected(start, start.parts[i], out);
  }
  return out;
}

std::vector<bool> loose_vertices(const io::Scene& scene, const io::Surface& surface) {
  std::vector<bool> loose(surface.positions.size(), false);
  for (size_t i = 0; i < surface.parts.size(); ++i) {
    if (!std::holds_alternative<io::MeshShape>(scene.cloths[i].shape)) continue;
    const auto first = loose.begin() + std::ptrdiff_t(surface.parts[i].first_vertex);
    std::fill_n(first, surface.parts[i].vertex_count, true);
  }
  for (const auto& triangle : surface.triangles) {
    for (const uint32_t v : triangle) loose[v] = false;
  }
  return loose;
}

std::vector<std::array<uint32_t, 2>> bars(const io::Scene& scene, const io::Surface& surface) {
  std::vector<std::array<uint32_t, 2>> out = surface.edges;
  std::vector<bool> shown = loose_vertices(scene, surface);
  for (size_t i = 0; i < surface.parts.size(); ++i) {
    const auto* grid = std::get_if<io::GridShape>(&scene.cloths[i].shape);
    if (!grid || !is_row(*grid)) continue;
    const auto first = uint32_t(surface.parts[i].first_vertex);
    const auto count = uint32_t(surface.parts[i].vertex_count);
    for (uint32_t v = first; v + 1 < first + count; ++v) out.push_back({v, v + 1});
  }
  for (const auto& bar : out) shown[bar[0]] = shown[bar[1]] = true;
  for (const auto& triangle : surface.triangles) {
    for (const uint32_t v : triangle) shown[v] = true;
  }
  for (uint32_t v = 0; v < shown.size(); ++v) {
    if (!shown[v]) out.push_back({v, v});
  }
  return out;
}

}  // namespace weft::render
