#include "render/framing.h"

#include "render/solids.h"
#include "render/weave.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weft::render {
namespace {

/// A horizontal direction that the upright parts of the cloths face; without any, along z.
Vector3d facing(const io::Surface& start, const Vector3d& up) {
  const Vector3d z = std::abs(up.z()) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitX();
  const Vector3d ahead = (z - up * up.dot(z)).normalized();
  const Vector3d aside = up.cross(ahead);
  double along = 0, across = 0;
  for (const double3& n : start.normals) {
    along += std::abs(ahead.dot(vector(n)));
    across += std::abs(aside.dot(vector(n)));
  }
  return across > 1.5 * along ? aside : ahead;
}

Axes axes_for(const io::Scene& scene, const io::Surface& start) {
  const io::CameraScene& camera = scene.camera;
  const Vector3d sky = up_of(scene), up = camera.up ? vector(*camera.up).normalized() : sky;
  if (camera.eye) return axes_of(vector(*camera.eye) - vector(*camera.target), up);
  const Vector3d ahead = facing(start, sky);
  return axes_of(ahead + 0.5 * sky.cross(ahead) + 0.42 * sky, up);
}

}  // namespace

Axes axes_of(const Vector3d& towards, const Vector3d& up) {
  const Vector3d back = towards.normalized();
  Vector3d right = up.cross(back);
  if (right.norm() < 1e-6) right = back.unitOrthogonal();
  right.normalize();
  return {right, back.cross(right), back};
}

Vector3d up_of(const io::Scene& scene) {
  const Vector3d gravity = vector(scene.gravity);
  return gravity.norm() > 0 ? Vector3d(-gravity.normalized()) : Vector3d::UnitY();
}

Framing::Framing(const io::Scene& scene, const io::Surface& start)
    : axes_(axes_for(scene, start)),
      loose_(loose_vertices(scene, start)),
      half_height_(std::tan(scene.camera.field_of_view * std::numbers::pi / 360)),
      half_width_(half_height_ * scene.camera.width / scene.camera.height) {
  if (scene.camera.eye) eye_ = vector(*scene.camera.eye);
  constexpr double margin = 1.12;
  const Vector3d wide = axes_.right * margin / half_width_;
  const Vector3d high = axes_.up * margin / half_height_;
  sides_ = {axes_.back + wide, axes_.back - wide, axes_.back + high, axes_.back - high};
  reach_.fill(-1e300);
  add(start);
}

void Framing::add(const io::Surface& surface) {
  for (size_t v = 0; v < surface.positions.size(); ++v) {
    if (!loose_[v]) add(vector(surface.positions[v]), 0);
  }
}

void Framing::add(const Vector3d& center, double radius) {
  box_.add(Box{center, center}.grown(radius));
  for (size_t i = 0; i < sides_.size(); ++i) {
    reach_[i] = std::max(reach_[i], sides_[i].dot(center) + radius * sides_[i].norm());
  }
  front_ = std::max(front_, axes_.back.dot(center) + radius);
  if (!eye_) return;
  const Vector3d from = center - *eye_;
  const double ahead = -axes_.back.dot(from);
  const bool in_view = std::abs(axes_.right.dot(from)) <= 1.2 * half_width_ * ahead + radius &&
                       std::abs(axes_.up.dot(from)) <= 1.2 * half_height_ * ahead + radius;
  if (ahead > 0 && in_view) nearest_ = std::min(nearest_, std::max(ahead - radius, 0.0));
}

void Framing::expect(const Box& box) {
  if (!eye_) return;
  nearest_ = std::min(nearest_, (eye_->cwiseMax(box.low).cwiseMin(box.high) - *eye_).norm());
}

// A point p is inside of a side with normal n, seen from e, when n.p <= n.e. Two opposite sides
// give e's place across the view, and their mean how far back it must be.
Vector3d Framing::eye() const {
  const Vector3d wide = 0.5 * (sides_[0] - sides_[1]), high = 0.5 * (sides_[2] - sides_[3]);
  const double across = 0.5 * (reach_[0] - reach_[1]) / wide.norm();
  const double along = 0.5 * (reach_[2] - reach_[3]) / high.norm();
  const double back = std::max(
      {(reach_[0] + reach_[1]) / 2, (reach_[2] + reach_[3]) / 2, front_ + 0.35 * box_.radius()});
  return axes_.right * across + axes_.up * along + axes_.back * back;
}

void add_colliders(const io::Scene& scene, Framing& framing) {
  const double size = framing.box().radius();
  const Box near = framing.box().grown(0.8 * size), close = framing.box().grown(0.3 * size);
  for (const io::ColliderScene& collider : scene.colliders) {
    const Box start = bounds_of(collider);
    if (start.empty()) continue;
    const Vector3d way = velocity_of(collider) * scene.time.duration;
    const int moments = way.norm() > 0 ? 32 : 0;
    for (int i = 0; i <= moments; ++i) {
      const Vector3d moved = moments > 0 ? Vector3d(way * (double(i) / moments)) : way;
      const Box all{start.low + moved, start.high + moved};
      framing.expect(all);
      if (all.within(near).empty()) continue;
      const bool large = all.radius() > 1.5 * size;  // what is near of it will do
      const auto* sphere = std::get_if<SphereDesc>(&collider);
      if (sphere && !large) {
        framing.add(vector(sphere->center) + moved, sphere->radius);
        continue;
      }
      const Box part = large ? all.within(close) : all;
      if (part.empty()) continue;
      for (int k = 0; k < 8; ++k) framing.add(part.corner(k));
    }
  }
}

}  // namespace weft::render
