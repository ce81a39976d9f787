#include "weft/debug_draw.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "api/world/call_guard.h"
#include "api/context/vector_math.h"
#include "api/world/state.h"
#include "scene/check.h"
#include "scene/each_spring.h"
#include "scene/trigonometry.h"

namespace weft {
inline namespace v0 {

namespace {

constexpr uint32_t yellow = 0xffd000ff, green = 0x30c060ff, grey = 0x909090ff;

/// Lines between points of one frame of reference.
class Pencil {
 public:
  Pencil(const DebugDraw& draw, const api::Placed& placed, uint32_t colour)
      : draw_(draw), placed_(placed), colour_(colour) {}

  void line(const double3& a, const double3& b) const { line(a, b, colour_); }
  /// One that leads nowhere, as of a cloth that has diverged, is left out.
  void line(const double3& a, const double3& b, uint32_t colour) const {
    const double3 from = api::to_world(placed_, a), to = api::to_world(placed_, b);
    if (!is_finite(from) || !is_finite(to)) return;
    draw_.line(draw_.user, from, to, colour);
  }
  /// Round `center`, in the plane of u and v, whose length is the radius.
  void circle(const double3& center, const double3& u, const double3& v) const {
    constexpr int corners = 24;
    double3 last = api::plus(center, u);
    for (int i = 1; i <= corners; ++i) {
      const auto [s, c] = scene::sine_cosine_degrees(i * 360.0 / corners);
      const double3 next = api::plus(center, api::plus(api::times(c, u), api::times(s, v)));
      line(last, next);
      last = next;
    }
  }
  void ball(const double3& center, double radius) const {
    const double3 x{radius, 0, 0}, y{0, radius, 0}, z{0, 0, radius};
    circle(center, x, y);
    circle(center, y, z);
    circle(center, z, x);
  }
  /// Half edges along three directions.
  void box(const double3& center, const double3* half) const {
    for (int axis = 0; axis < 3; ++axis) {
      const double3 &u = half[(axis + 1) % 3], &v = half[(axis + 2) % 3];
      for (const double a : {-1.0, 1.0}) {
        for (const double b : {-1.0, 1.0}) {
          const double3 middle = api::plus(center, api::plus(api::times(a, u), api::times(b, v)));
          line(api::minus(middle, half[axis]), api::plus(middle, half[axis]));
        }
      }
    }
  }
  void rod(const double3& from, const double3& to, const double3& u, const double3& v) const {
    circle(from, u, v);
    circle(to, u, v);
    for (const double side : {-1.0, 1.0}) {
      for (const double3& across : {u, v}) {
        const double3 by = api::times(side, across);
        line(api::plus(from, by), api::plus(to, by));
      }
    }
  }

 private:
  static bool is_finite(const double3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }

  const DebugDraw& draw_;
  const api::Placed placed_;
  uint32_t colour_;
};

void draw_collider(const DebugDraw& draw, const api::ColliderRecord& c, double time) {
  const api::Placed placed = path_of(c, time, 0).begin;
  const Pencil pencil(draw, placed, green);
  switch (c.shape) {
    case ColliderShape::sphere:
      return pencil.ball({0, 0, 0}, c.size);
    case ColliderShape::plane: {
      // A square of two metres round the point next to the origin, and its normal.
      const double3 n = c.normal, foot{0, 0, 0};
      const double3 other = std::fabs(n.x) < 0.7 ? double3{1, 0, 0} : double3{0, 1, 0};
      double3 u = api::outer(n, other);
      u = api::times(1 / api::length(u), u);
      const double3 flat[3] = {u, api::outer(n, u), {0, 0, 0}};
      pencil.box(foot, flat);
      return pencil.line(foot, api::plus(foot, api::times(0.3, n)));
    }
    case ColliderShape::capsule: {
      const double3 foot = c.to_point, end = api::times(-1, foot);
      pencil.ball(foot, c.size);
      pencil.ball(end, c.size);
      const double size = api::length(c.axis);
      if (size == 0) return;
      const double3 u = api::times(c.size, c.side);
      return pencil.rod(foot, end, u, api::outer(api::times(1 / size, c.axis), u));
    }
    case ColliderShape::cylinder: {
      const double3 u = api::times(c.size, c.side);
      return pencil.rod(c.to_point, api::times(-1, c.to_point), u, api::outer(c.axis, u));
    }
    case ColliderShape::box:
    case ColliderShape::mesh: {
      const double3 half[3] = {api::times(c.half.x, c.edges[0]), api::times(c.half.y, c.edges[1]),
                               api::times(c.half.z, c.edges[2])};
      return pencil.box({0, 0, 0}, half);
    }
  }
}

uint32_t colour_of(double strain) {
  const double s = std::isfinite(strain) ? std::clamp(strain, -1.0, 1.0) : 1;
  const auto fade = static_cast<uint32_t>(255 * (1 - std::fabs(s)) + 0.5);
  const uint32_t red = s >= 0 ? 255 : fade, blue = s <= 0 ? 255 : fade;
  return red << 24 | fade << 16 | blue << 8 | 0xff;
}

/// What is drawn of a cloth: a copy, for whoever draws may do with the world what he likes.
struct DrawnCloth {
  Fabric fabric;
  Vector<double3> x;
  Vector<uint32_t> pinned;
  Bounds bounds;
};

void draw_springs(const DebugDraw& draw, const DrawnCloth& cloth) {
  const scene::CookedFabric& fabric = cloth.fabric.impl()->cooked;
  const Pencil pencil(draw, api::Placed(), 0);
  scene::each_spring(fabric, [&](uint32_t i, uint32_t j, double, double rest) {
    const double length = api::length(api::minus(cloth.x[i], cloth.x[j]));
    if (rest < 0) {
      rest = api::length(api::minus(fabric.position_of(i), fabric.position_of(j)));
    }
    const double strain = rest > 0 ? (length - rest) / rest / draw.full_strain : 0;
    pencil.line(cloth.x[i], cloth.x[j], colour_of(strain));
  });
}

void draw_cloth(const DebugDraw& draw, const DrawnCloth& cloth) {
  const Bounds& b = cloth.bounds;
  if (draw.what & DebugDraw::springs) draw_springs(draw, cloth);
  if (draw.what & DebugDraw::pins) {
    const double size = std::max(0.01 * api::length(api::minus(b.high, b.low)), 1e-3);
    const Pencil pencil(draw, api::Placed(), yellow);
    for (const uint32_t v : cloth.pinned) {
      for (const double3& d : {double3{size, 0, 0}, double3{0, size, 0}, double3{0, 0, size}}) {
        pencil.line(api::minus(cloth.x[v], d), api::plus(cloth.x[v], d));
      }
    }
  }
  if (draw.what & DebugDraw::bounds) {
    const double3 size = api::times(0.5, api::minus(b.high, b.low));
    const double3 half[3] = {{size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}};
    Pencil(draw, api::Placed(), grey).box(api::times(0.5, api::plus(b.low, b.high)), half);
  }
}

struct Drawing {
  Vector<DrawnCloth> cloths;
  Vector<api::ColliderRecord> colliders;
  double time = 0;
};

Status copy_of(World::Impl& world, World& self, const DebugDraw& draw, Drawing& out) {
  out.time = world.time;
  for (const ClothId id : world.order) {
    const api::ClothRecord& cloth = *world.find(id);
    if (cloth.cooked().vertices == 0) continue;
    DrawnCloth& drawn = out.cloths.emplace_back();
    drawn.fabric = cloth.fabric;
    drawn.bounds = cloth.bounds;
    if (draw.what & (DebugDraw::springs | DebugDraw::pins)) {
      drawn.x.resize(cloth.cooked().vertices);
      const Status status = self.read_positions(id, drawn.x.data());
      if (status != Status::ok) return status;
    }
    for (const api::PinRecord& pin : cloth.pins) drawn.pinned.push_back(pin.vertex);
  }
  if (draw.what & DebugDraw::colliders) {
    for (const api::ColliderRecord& c : world.colliders) {
      if (c.id) out.colliders.push_back(c);
    }
  }
  return Status::ok;
}

}  // namespace

Status World::debug_draw(const DebugDraw& given) noexcept {
  const DebugDraw draw = given;
  // Outlives the copy whose memory it is, also where a line's function destroys the world.
  std::shared_ptr<api::ContextState> context;
  std::optional<Drawing> drawing;
  {
    const api::CallGuard guard(impl_);
    if (!guard) return guard.status();
    context = impl_->context;
    const Status status = api::guarded(*context, [&] {
      if (!draw.line) {
        throw InvalidInput("line is null (the lines must go somewhere) give a function");
      }
      scene::check_positive(draw.full_strain, "full_strain");
      return copy_of(*impl_, *this, draw, drawing.emplace());
    });
    if (status != Status::ok) return status;
  }
  for (const DrawnCloth& cloth : drawing->cloths) draw_cloth(draw, cloth);
  for (const api::ColliderRecord& c : drawing->colliders) draw_collider(draw, c, drawing->time);
  return Status::ok;
}

}  // namespace v0
}  // namespace weft
