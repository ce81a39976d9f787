#include "render/stage.h"

#include "render/solids.h"

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

void place_ground(const io::Scene& scene, const Vector3d& up, double gap, Stage& stage) {
  double lowest = 1e300;
  for (int i = 0; i < 8; ++i) lowest = std::min(lowest, up.dot(stage.seen.corner(i)));
  Vector3d normal = up;
  double offset = lowest - gap;
  if (const PlaneDesc* plane = ground_plane(scene, up)) {
    const double length = vector(plane->normal).norm();
    normal = vector(plane->normal) / length;
    offset = plane->offset / length - 0.02 * gap;
    stage.ground_velocity = (normal.dot(vector(plane->velocity)) * normal).cast<float>();
  }
  stage.ground = ((offset - normal.dot(stage.origin)) * normal).cast<float>();
  stage.ground_normal = normal.cast<float>();
}

}  // namespace

Stage make_stage(const io::Scene& scene, Framing framing) {
  if (framing.box().radius() < 1e-9) framing.add(framing.box().center(), 1e-3);  // a point at rest
  const double size = framing.box().radius();
  add_colliders(scene, framing);
  Stage stage;
  stage.seen = framing.box().grown(0.01 * size);
  stage.origin = stage.seen.center();
  stage.radius = float(stage.seen.radius());
  const Vector3d eye =
      (scene.camera.eye ? vector(*scene.camera.eye) : framing.eye()) - stage.origin;
  stage.eye = eye.cast<float>();
  const double radius = stage.radius, distance = eye.norm();
  const double near = std::clamp(0.7 * framing.nearest(), nearest_drawn(radius),
                                 std::max(0.01 * radius, distance - 3 * radius));
  stage.camera = perspective(framing, near, distance + 40 * radius) * looking(framing.axes(), eye);
  const Vector3d up = up_of(scene);
  place_light(framing.axes(), up, stage);
  place_ground(scene, up, 0.01 * size, stage);
  return stage;
}

}  // namespace weft::render
