#include "render/framing.h"

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

Framing::Framing(const io::Scene& scene, const io::Surface& start)
    : axes_(axes_for(scene, start)),
      half_height_(std::tan(scene.camera.field_of_view * std::numbers::pi / 360)),
      half_width_(half_height_ * scene.camera.width / scene.camera.height) {
  constexpr double margin = 1.12;
  const Vector3d wide = axes_.right * margin / half_width_;
  const Vector3d high = axes_.up * margin / half_height_;
  sides_ = {axes_.back + wide, axes_.back - wide, axes_.back + high, axes_.back - high};
  reach_.fill(-1e300);
}

void Framing::add(const Vector3d& point) {
  box_.add(point);
  for (size_t i = 0; i < sides_.size(); ++i) {
    reach_[i] = std::max(reach_[i], sides_[i].dot(point));
  }
  front_ = std::max(front_, axes_.back.dot(point));
}

void Framing::add(const Box& box) {
  for (int i = 0; i < 8; ++i) add(box.corner(i));
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

void add_colliders(const std::vector<Solid>& solids, double duration, Framing& framing) {
  const double size = framing.box().radius();
  const Box near = framing.box().grown(0.8 * size), close = framing.box().grown(0.3 * size);
  for (const Solid& solid : solids) {
    if (solid.kind != Solid::Kind::body) continue;
    const Vector3d way = solid.velocity * duration;
    const int moments = way.norm() > 0 ? 32 : 0;
    for (int i = 0; i <= moments; ++i) {
      const Vector3d by = way * (double(i) / std::max(moments, 1));
      const Box all = solid.box.moved(by);
      if (all.within(near).empty()) continue;
      if (all.radius() <= 1.5 * size) {
        for (const Vector3d& p : solid.surface.places) framing.add(p + by);
      } else if (const Box part = all.within(close); !part.empty()) {  // the rest may be cut off
        framing.add(part);
      }
    }
  }
}

}  // namespace weft::render
