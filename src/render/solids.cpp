#include "render/solids.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weft::render {
namespace {

constexpr double pi = std::numbers::pi;

/// A circle of vertices around an axis: how far out and up they are, and where they face.
struct Ring {
  double out, up, facing_out, facing_up;
};

/// A surface of revolution around `axis`, of rings from the lowest to the highest.
Triangles revolved(const Vector3d& foot, const Vector3d& axis, const std::vector<Ring>& rings,
                   uint32_t corners) {
  const Vector3d x = axis.unitOrthogonal(), y = axis.cross(x);
  Triangles made;
  for (const Ring& ring : rings) {
    const auto row = uint32_t(made.places.size());
    for (uint32_t i = 0; i < corners; ++i) {
      const double angle = 2 * pi * i / corners;
      const Vector3d out = std::cos(angle) * x + std::sin(angle) * y;
      made.places.push_back(foot + ring.out * out + ring.up * axis);
      made.normals.push_back(ring.facing_out * out + ring.facing_up * axis);
      if (row == 0) continue;
      const uint32_t a = row + i, b = row + (i + 1) % corners;
      made.indices.insert(made.indices.end(), {a - corners, b - corners, a, b - corners, b, a});
    }
  }
  return made;
}

/// A sphere of which the picture shows a small part, around its `top`: the nearer to that, the
/// closer its rings, which begin `finest` away from it.
Triangles planet(const Vector3d& top, const Vector3d& up, double radius, double finest) {
  constexpr int rings = 96;
  const double growth = std::pow(pi * radius / finest, 1.0 / (rings - 1));
  std::vector<Ring> profile;
  for (int r = rings; r >= 0; --r) {
    const double angle = r == 0 ? 0 : std::min(finest / radius * std::pow(growth, r - 1), pi);
    const double wide = std::sin(angle), half = std::sin(angle / 2);
    profile.push_back({radius * wide, -2 * radius * half * half, wide, 1 - 2 * half * half});
  }
  return revolved(top, up, profile, rings);
}

Triangles box(const Eigen::Matrix3d& axes, const Vector3d& center) {
  Triangles made;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto first = uint32_t(made.places.size());
      for (int corner = 0; corner < 4; ++corner) {
        Vector3d at = Vector3d::Constant(side);
        at[(axis + 1) % 3] = corner & 1 ? 1 : -1;
        at[(axis + 2) % 3] *= corner & 2 ? 1 : -1;
        made.places.push_back(center + axes * at);
        made.normals.push_back(side * axes.col(axis).normalized());
      }
      for (const uint32_t corner : {0u, 1u, 2u, 1u, 3u, 2u}) made.indices.push_back(first + corner);
    }
  }
  return made;
}

Eigen::Matrix3d rotation(double3 axis, double degrees) {
  const Vector3d v = vector(axis);
  if (v.norm() == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(degrees * pi / 180, v.normalized()).toRotationMatrix();
}

struct Maker {
  const Box& region;

  Triangles operator()(const SphereDesc& d) const {
    const Vector3d center = vector(d.center), towards = region.center() - center;
    if (d.radius <= 2 * region.radius()) return capsule(center, center, d.radius, 96);
    const Vector3d up = towards.norm() > 0 ? Vector3d(towards.normalized()) : Vector3d::UnitY();
    return planet(center + d.radius * up, up, d.radius, 0.02 * region.radius());
  }
  Triangles operator()(const CapsuleDesc& d) const {
    return capsule(vector(d.a), vector(d.b), d.radius, 96);
  }
  Triangles operator()(const CylinderDesc& d) const {
    const Vector3d along = vector(d.b) - vector(d.a);
    const double r = d.radius, h = along.norm();
    return revolved(
        vector(d.a), along.normalized(),
        {{0, 0, 0, -1}, {r, 0, 0, -1}, {r, 0, 1, 0}, {r, h, 1, 0}, {r, h, 0, 1}, {0, h, 0, 1}}, 96);
  }
  Triangles operator()(const BoxDesc& d) const {
    return box(rotation(d.axis, d.degrees) * vector(d.half).asDiagonal(), vector(d.center));
  }
  Triangles operator()(const PlaneDesc& d) const {
    const double length = vector(d.normal).norm();
    const Vector3d n = vector(d.normal) / length, middle = region.center();
    const Vector3d foot = middle + n * (d.offset / length - n.dot(middle));
    return revolved(foot, n, {{3 * region.radius(), 0, 0, 1}, {0, 0, 0, 1}}, 96);
  }
  Triangles operator()(const io::MeshColliderScene& d) const {
    const Eigen::Matrix3d axes = rotation(d.pose.axis, d.pose.degrees) * d.scale;
    std::vector<Vector3d> places;
    for (const double3& p : d.mesh->positions) {
      places.push_back(axes * vector(p) + vector(d.pose.translate));
    }
    return with_creases(places, d.mesh->triangles);
  }
};

}  // namespace

Triangles capsule(const Vector3d& a, const Vector3d& b, double radius, uint32_t corners) {
  const double length = (b - a).norm();
  const int rings = int(corners / 4);  // of a half sphere
  std::vector<Ring> profile;
  for (const double end : {0.0, 1.0}) {
    for (int r = 0; r <= rings; ++r) {
      const double angle = pi / 2 * (double(r) / rings - 1 + end);
      const double out = std::cos(angle), up = std::sin(angle);
      profile.push_back({radius * out, end * length + radius * up, out, up});
    }
  }
  const Vector3d axis = length > 0 ? Vector3d((b - a) / length) : Vector3d::UnitZ();
  return revolved(a, axis, profile, corners);
}

Vector3d up_of(const io::Scene& scene) {
  const Vector3d gravity = vector(scene.gravity);
  return gravity.norm() > 0 ? Vector3d(-gravity.normalized()) : Vector3d::UnitY();
}

std::vector<Solid> make_solids(const io::Scene& scene, const Box& region) {
  std::vector<Solid> solids;
  Solid* ground = nullptr;
  double best = 0.7;
  solids.reserve(scene.colliders.size());
  for (const io::ColliderScene& collider : scene.colliders) {
    Solid& solid = solids.emplace_back();
    solid.surface = std::visit(Maker{region}, collider);
    solid.velocity = std::visit([](const auto& d) { return vector(d.velocity); }, collider);
    for (const Vector3d& p : solid.surface.places) solid.box.add(p);
    if (!std::holds_alternative<PlaneDesc>(collider)) continue;
    solid.kind = Solid::Kind::plane;
    const double rise = solid.surface.normals[0].dot(up_of(scene));
    if (rise <= best) continue;
    best = rise;
    ground = &solid;
  }
  if (ground) ground->kind = Solid::Kind::ground;
  return solids;
}

}  // namespace weft::render
