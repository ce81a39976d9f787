#include "render/cloths.h"

#include <algorithm>

namespace weft::render {
namespace {

struct Dyes {
  Vector3f ground, stripe, line;
};

/// Of cloth after cloth.
const std::array<Dyes, 4> dyes{
    {{{0.50f, 0.045f, 0.05f}, {0.055f, 0.075f, 0.16f}, {0.9f, 0.72f, 0.3f}},
     {{0.07f, 0.22f, 0.30f}, {0.62f, 0.58f, 0.46f}, {0.75f, 0.2f, 0.1f}},
     {{0.62f, 0.40f, 0.09f}, {0.25f, 0.08f, 0.06f}, {0.9f, 0.85f, 0.7f}},
     {{0.16f, 0.28f, 0.13f}, {0.05f, 0.07f, 0.10f}, {0.8f, 0.8f, 0.7f}}}};

/// Two ends and a radius.
using Bar = std::array<float, 7>;

/// Along z, with fewer corners where there are many.
Triangles bar_form(size_t count) {
  return capsule(-Vector3d::UnitZ(), Vector3d::UnitZ(), 1, count > 2000 ? 4 : 12);
}

Box box_of(const io::Surface& start, const io::SurfacePart& part) {
  return render::box_of({&start.positions[part.first_vertex], part.vertex_count});
}

std::array<float, 6> pack(const Vector3d& at, const Vector3d& facing) {
  const Vector3f p = at.cast<float>(), n = facing.cast<float>();
  return {p.x(), p.y(), p.z(), n.x(), n.y(), n.z()};
}

}  // namespace

std::vector<WeaveVertex> weave_vertices(const io::Scene& scene, const io::Surface& start) {
  std::vector<WeaveVertex> out;
  out.reserve(start.positions.size());
  for (size_t i = 0; i < start.parts.size(); ++i) {
    const io::ClothScene& cloth = scene.cloths[i];
    const io::SurfacePart& part = start.parts[i];
    const auto* grid = std::get_if<io::GridShape>(&cloth.shape);
    const Box box = box_of(start, part);
    for (size_t k = 0; k < part.vertex_count; ++k) {
      const size_t v = part.first_vertex + k;
      if (grid) {
        const double x = grid->width / std::max(1u, grid->columns - 1);
        const double y = grid->height / std::max(1u, grid->rows - 1);
        const auto row = double(k / grid->columns), column = double(k % grid->columns);
        out.push_back(pack(cloth.scale * Vector3d(column * x, row * y, 0), {0, 0, 1}));
      } else {
        const Vector3d n = start.normals.empty() ? Vector3d::UnitZ() : vector(start.normals[v]);
        out.push_back(pack(vector(start.positions[v]) - box.low, n));
      }
    }
  }
  return out;
}

std::vector<std::array<uint32_t, 2>> bars(const io::Scene& scene, const io::Surface& surface) {
  std::vector<std::array<uint32_t, 2>> out = surface.edges;
  for (size_t i = 0; i < surface.parts.size(); ++i) {
    const auto* grid = std::get_if<io::GridShape>(&scene.cloths[i].shape);
    if (!grid || (grid->rows > 1 && grid->columns > 1)) continue;
    const auto first = uint32_t(surface.parts[i].first_vertex);
    const auto count = uint32_t(surface.parts[i].vertex_count);
    for (uint32_t v = first; v + 1 < first + count; ++v) out.push_back({v, v + 1});
  }
  std::vector<bool> shown(surface.positions.size(), false);
  for (const auto& bar : out) shown[bar[0]] = shown[bar[1]] = true;
  for (const auto& triangle : surface.triangles) {
    for (const uint32_t v : triangle) shown[v] = true;
  }
  for (uint32_t v = 0; v < shown.size(); ++v) {
    if (!shown[v]) out.push_back({v, v});
  }
  return out;
}

Cloths::Cloths(const io::Scene& scene, const io::Surface& start, float thickness)
    : bars_(bars(scene, start)),
      bar_(bar_form(bars_.size()), Vector3d::Zero()),
      bar_radius_(thickness / 2) {
  for (const io::SurfacePart& part : start.parts) {
    const Box box = box_of(start, part);
    const double size = std::max((box.high - box.low).maxCoeff(), 1e-9);
    parts_.push_back({3 * part.first_triangle, 3 * part.triangle_count, float(6 / size)});
  }
  glBindVertexArray(array_.name());
  const std::vector<WeaveVertex> weave = weave_vertices(scene, start);
  constexpr size_t stride = 6 * sizeof(float), half = 3 * sizeof(float);
  fill(weave_, GL_ARRAY_BUFFER, weave.data(), weave.size() * stride, GL_STATIC_DRAW);
  fill(indices_, GL_ELEMENT_ARRAY_BUFFER, start.triangles.data(),
       start.triangles.size() * sizeof start.triangles[0], GL_STATIC_DRAW);
  attribute(0, moving_, 3, stride, 0);
  attribute(1, moving_, 3, stride, half);
  attribute(2, weave_, 3, stride, 0);
  attribute(3, weave_, 3, stride, half);
  glBindVertexArray(bar_.array().name());
  attribute(4, bar_places_, 3, sizeof(Bar), 0, true);
  attribute(5, bar_places_, 3, sizeof(Bar), half, true);
  attribute(6, bar_places_, 1, sizeof(Bar), 2 * half, true);
}

void Cloths::update(const io::Surface& surface, const Vector3d& origin) {
  vertices_.resize(surface.positions.size());
  for (size_t i = 0; i < vertices_.size(); ++i) {
    vertices_[i] = pack(vector(surface.positions[i]) - origin, vector(surface.normals[i]));
  }
  fill(moving_, GL_ARRAY_BUFFER, vertices_.data(), vertices_.size() * sizeof vertices_[0],
       GL_STREAM_DRAW);
  std::vector<Bar> placed;
  for (const auto& [i, j] : bars_) {
    const auto &a = vertices_[i], &b = vertices_[j];
    const float radius = i == j ? 1.6f * bar_radius_ : bar_radius_;
    placed.push_back({a[0], a[1], a[2], b[0], b[1], b[2], radius});
  }
  fill(bar_places_, GL_ARRAY_BUFFER, placed.data(), placed.size() * sizeof(Bar), GL_STREAM_DRAW);
}

void Cloths::draw_sheets(const Program& program) const {
  program.use();
  glBindVertexArray(array_.name());
  for (size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    const Dyes& dye = dyes[i % dyes.size()];
    program.set("ground_colour", dye.ground);
    program.set("stripe_colour", dye.stripe);
    program.set("line_colour", dye.line);
    program.set("stripes", part.stripes);
    glDrawElements(GL_TRIANGLES, GLsizei(part.index_count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(part.first_index * sizeof(uint32_t)));
  }
}

void Cloths::draw_bars(const Program& program) const {
  program.use();
  program.set("colour", dyes[0].ground);
  bar_.draw(bars_.size());
}

}  // namespace weft::render
