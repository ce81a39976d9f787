#include "render/weavings.h"

#include <algorithm>
#include <cmath>

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

/// So many are drawn round.
constexpr size_t few_bars = 2000;

/// The longest side of the box around a cloth as it starts.
double extent(const io::Surface& start, const io::SurfacePart& part) {
  Box box;
  for (size_t i = 0; i < part.vertex_count; ++i) {
    box.add(vector(start.positions[part.first_vertex + i]));
  }
  return std::max((box.high - box.low).maxCoeff(), 1e-9);
}

}  // namespace

Weavings::Weavings(const io::Scene& scene, const io::Surface& start, const Stage& stage)
    : bars_(bars(scene, start)),
      bar_models_(bars_.size() > few_bars ? 4 : 12),
      bar_radius_(0.006f * stage.radius) {
  for (const io::SurfacePart& part : start.parts) {
    const double size = extent(start, part);
    parts_.push_back(
        {3 * part.first_triangle, 3 * part.triangle_count, float(144 / size), float(6 / size)});
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
}

void Weavings::update(const io::Surface& surface, const Vector3d& origin) {
  vertices_.resize(surface.positions.size());
  for (size_t i = 0; i < vertices_.size(); ++i) {
    const Vector3f p = (vector(surface.positions[i]) - origin).cast<float>();
    const Vector3f n = vector(surface.normals[i]).cast<float>();
    vertices_[i] = {p.x(), p.y(), p.z(), n.x(), n.y(), n.z()};
  }
  fill(moving_, GL_ARRAY_BUFFER, vertices_.data(), vertices_.size() * sizeof vertices_[0],
       GL_STREAM_DRAW);
  std::vector<std::array<float, 7>> capsules;
  for (const auto& [i, j] : bars_) {
    const auto &a = vertices_[i], &b = vertices_[j];
    const float radius = i == j ? 1.6f * bar_radius_ : bar_radius_;
    capsules.push_back({a[0], a[1], a[2], b[0], b[1], b[2], radius});
  }
  bar_models_.fill(capsules);
}

void Weavings::draw_cloths(const Program& program) const {
  program.use();
  glBindVertexArray(array_.name());
  for (size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    const Dyes& dye = dyes[i % dyes.size()];
    if (part.index_count == 0) continue;
    program.set("ground_colour", dye.ground);
    program.set("stripe_colour", dye.stripe);
    program.set("line_colour", dye.line);
    program.set("threads", part.threads);
    program.set("stripes", part.stripes);
    glDrawElements(GL_TRIANGLES, GLsizei(part.index_count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(part.first_index * sizeof(uint32_t)));
  }
}

void Weavings::draw_bars(const Program& program) const {
  program.use();
  program.set("colour", dyes[0].ground);
  bar_models_.draw();
}

}  // namespace weft::render
