#include "render/stage.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace weft::render {
namespace {

using Eigen::Matrix4f;

/// Rows are the axes: from picture coordinates to those of who looks from `eye`.
Matrix4f looking(const Axes& axes, const Vector3d& eye) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.block<1, 3>(0, 0) = axes.right.transpose();
  m.block<1, 3>(1, 0) = axes.up.transpose();
  m.block<1, 3>(2, 0) = axes.back.transpose();
  m.block<3, 1>(0, 3) = -m.block<3, 3>(0, 0) * eye;
  return m.cast<float>();
}

Matrix4f perspective(const Framing& framing, double near, double far) {
  Matrix4f m = Matrix4f::Zero();
  m(0, 0) = float(1 / framing.half_width());
  m(1, 1) = float(1 / framing.half_height());
  m(2, 2) = float((far + near) / (near - far));
  m(2, 3) = float(2 * far * near / (near - far));
  m(3, 2) = -1;
  return m;
}

/// A square beam of half the width `radius`, from `ahead` of the middle to `behind` it.
Matrix4f beam(double radius, double ahead, double behind) {
  Matrix4f m = Matrix4f::Identity();
  m(0, 0) = m(1, 1) = float(1 / radius);
  m(2, 2) = float(-2 / (ahead + behind));
  m(2, 3) = float((ahead - behind) / (ahead + behind));
  return m;
}

/// From above, in front and to the left of who looks.
void place_light(const Axes& view, const Vector3d& up, Stage& stage) {
  Vector3d level = view.back - up * up.dot(view.back);
  level = level.norm() > 1e-3 ? Vector3d(level.normalized()) : view.up;
  const Vector3d light = (up + 0.5 * level + 0.45 * level.cross(up)).normalized();
  const double radius = stage.radius;
  stage.light = light.cast<float>();
  stage.shadow = beam(1.02 * radius, 1.05 * radius, 6 * radius) *
                 looking(axes_of(light, std::abs(light.dot(up)) > 0.99 ? level : up), {0, 0, 0});
}

void place_ground(const std::vector<Solid>& solids, const Box& seen, Stage& stage) {
  const Vector3d up = stage.up.cast<double>();
  double lowest = 1e300;
  for (int i = 0; i < 8; ++i) lowest = std::min(lowest, up.dot(seen.corner(i) - stage.origin));
  stage.ground = (lowest * up).cast<float>();
  stage.ground_normal = stage.up;
  for (const Solid& solid : solids) {
    if (solid.kind != Solid::Kind::ground) continue;
    const Vector3d normal = solid.surface.normals[0];
    stage.floor = false;
    stage.ground = (normal.dot(solid.surface.places[0] - stage.origin) * normal).cast<float>();
    stage.ground_normal = normal.cast<float>();
    stage.ground_velocity = (normal.dot(solid.velocity) * normal).cast<float>();
  }
}

}  // namespace

Stage make_stage(const io::Scene& scene, const io::Surface& start,
                 const std::vector<Solid>& solids) {
  Framing framing(scene, start);
  add_cloths(scene, start, solids, framing);
  const double size = framing.box().radius();
  if (size < 1e-9) {  // a point at rest
    const Vector3d point = framing.box().center(), up = 1e-3 * framing.axes().up;
    framing.add(point + up);
    framing.add(point - up);
  }
  add_colliders(solids, scene.time.duration, framing);
  const Box seen = framing.box().grown(0.01 * size);
  Stage stage;
  stage.origin = seen.center();
  stage.radius = float(seen.radius());
  const Vector3d eye = scene.camera.eye ? vector(*scene.camera.eye) : framing.eye();
  const Vector3d from = eye - stage.origin;
  stage.eye = from.cast<float>();
  // What comes nearer than a part of the way to all that is expected is cut off.
  const double away = (framing.box().nearest(eye) - eye).norm();
  const double near = std::max(3e-4 * seen.radius(), 0.05 * away);
  const double far = from.norm() + 40 * seen.radius();
  stage.camera = perspective(framing, near, far) * looking(framing.axes(), from);
  stage.up = up_of(scene).cast<float>();
  place_light(framing.axes(), up_of(scene), stage);
  place_ground(solids, seen, stage);
  return stage;
}

}  // namespace weft::render
