#include "render/solids.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>

namespace weft::render {
namespace {

/// Columns: two directions across `axis`, and it.
Eigen::Matrix3d frame_along(const Vector3d& axis) {
  Eigen::Matrix3d m;
  m.col(2) = axis.normalized();
  m.col(0) = m.col(2).unitOrthogonal();
  m.col(1) = m.col(2).cross(m.col(0));
  return m;
}

Box box_round(const Vector3d& center, const Vector3d& half) {
  return {center - half, center + half};
}

struct Bounds {
  Box operator()(const SphereDesc& d) const {
    return box_round(vector(d.center), Vector3d::Constant(d.radius));
  }
  Box operator()(const PlaneDesc&) const { return {}; }
  // Its caps reach as far along an axis as they are seen edge on.
  Box operator()(const CylinderDesc& d) const {
    const Vector3d along = (vector(d.b) - vector(d.a)).normalized();
    const Vector3d rim = d.radius * (1 - along.array().square()).max(0).sqrt().matrix();
    Box box;
    box.add(box_round(vector(d.a), rim));
    box.add(box_round(vector(d.b), rim));
    return box;
  }
  Box operator()(const CapsuleDesc& d) const { return between(d.a, d.b, d.radius); }
  Box operator()(const BoxDesc& d) const {
    const Eigen::Matrix3d turn = rotation(d.axis, d.degrees);
    return box_round(vector(d.center), turn.cwiseAbs() * vector(d.half));
  }
  Box operator()(const io::MeshColliderScene& d) const {
    const Eigen::Matrix3d turn = rotation(d.pose.axis, d.pose.degrees) * d.scale;
    Box box;
    for (const double3& p : d.mesh->positions) {
      box.add(turn * vector(p) + vector(d.pose.translate));
    }
    return box;
  }

 private:
  static Box between(double3 a, double3 b, double radius) {
    Box box;
    box.add(vector(a));
    box.add(vector(b));
    return box.grown(radius);
  }
};

class Maker {
 public:
  Maker(const Box& region, Solids& out)
      : region_(region), hair_(5e-4 * region.radius()), out_(out) {}

  void make(const io::ColliderScene& collider, size_t number, double reach) {
    number_ = number;
    slack_ = reach + hair_;
    std::visit(*this, collider);
  }

  void operator()(const SphereDesc& d) {
    if (d.radius > 2 * region_.radius()) return add_planet(d);
    add_capsule(d.center, d.center, d.radius, d.velocity);
  }
  void operator()(const CapsuleDesc& d) { add_capsule(d.a, d.b, d.radius, d.velocity); }
  void operator()(const CylinderDesc& d) {
    const Vector3d a = vector(d.a), b = vector(d.b), half = 0.5 * (b - a);
    Eigen::Matrix3d axes = frame_along(half);
    const double slack = slack_within(std::min(d.radius, half.norm()));
    axes.leftCols<2>() *= d.radius - slack;
    axes.col(2) *= half.norm() - slack;
    out_.solids.push_back({Form::cylinder, axes, 0.5 * (a + b), vector(d.velocity)});
  }
  void operator()(const BoxDesc& d) {
    const Vector3d half = vector(d.half);
    const Vector3d drawn = half - Vector3d::Constant(slack_within(half.minCoeff()));
    const Eigen::Matrix3d axes = rotation(d.axis, d.degrees) * drawn.asDiagonal();
    out_.solids.push_back({Form::box, axes, vector(d.center), vector(d.velocity)});
  }
  void operator()(const PlaneDesc& d) {
    const Vector3d normal = vector(d.normal);
    const double length = normal.norm();
    const Vector3d n = normal / length, middle = region_.center();
    const double radius = 1.2 * region_.radius();
    const Vector3d foot = middle + n * (d.offset / length - n.dot(middle) - hair_);
    out_.solids.push_back({Form::disc, frame_along(n) * radius, foot, vector(d.velocity)});
  }
  void operator()(const io::MeshColliderScene& d) {
    const Eigen::Matrix3d axes = rotation(d.pose.axis, d.pose.degrees) * d.scale;
    out_.solids.push_back({Form::collider_mesh, axes, vector(d.pose.translate), vector(d.velocity),
                           out_.collider_meshes.size()});
    out_.collider_meshes.push_back(number_);
  }

 private:
  double slack_within(double size) const { return std::min(slack_, 0.5 * size); }

  void add_capsule(double3 a, double3 b, double radius, double3 velocity) {
    out_.capsules.push_back(
        {vector(a), vector(b), radius - slack_within(radius), vector(velocity)});
  }

  // Floats and the corners of a capsule are too coarse for a sphere much larger than the scene.
  void add_planet(const SphereDesc& d) {
    const Vector3d center = vector(d.center), towards = region_.center() - center;
    const Vector3d up = towards.norm() > 0 ? Vector3d(towards.normalized()) : Vector3d::UnitY();
    const double radius = d.radius - slack_within(d.radius);
    out_.meshes.push_back(planet_form(0.02 * region_.radius() / d.radius));
    out_.solids.push_back({Form::mesh, frame_along(up) * radius, center + radius * up,
                           vector(d.velocity), out_.meshes.size() - 1});
  }

  const Box& region_;
  double hair_;  ///< what keeps two surfaces apart in the depth buffer
  double slack_ = 0;
  size_t number_ = 0;
  Solids& out_;
};

}  // namespace

const PlaneDesc* ground_plane(const io::Scene& scene, const Vector3d& up) {
  const PlaneDesc* found = nullptr;
  double best = 0.7;
  for (const io::ColliderScene& collider : scene.colliders) {
    const auto* plane = std::get_if<PlaneDesc>(&collider);
    if (!plane) continue;
    const double rise = vector(plane->normal).normalized().dot(up);
    if (rise <= best) continue;
    best = rise;
    found = plane;
  }
  return found;
}

Eigen::Matrix3d rotation(double3 axis, double degrees) {
  const Vector3d v = vector(axis);
  if (v.norm() == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, v.normalized()).toRotationMatrix();
}

double most_given(const io::ColliderScene& collider) {
  struct Half {
    double operator()(const SphereDesc& d) const { return d.radius; }
    double operator()(const CapsuleDesc& d) const { return d.radius; }
    double operator()(const CylinderDesc& d) const {
      return std::min(d.radius, 0.5 * (vector(d.b) - vector(d.a)).norm());
    }
    double operator()(const BoxDesc& d) const { return vector(d.half).minCoeff(); }
    double operator()(const PlaneDesc&) const { return 0; }
    double operator()(const io::MeshColliderScene&) const { return 0; }
  };
  return 0.5 * std::visit(Half(), collider);
}

Vector3d velocity_of(const io::ColliderScene& collider) {
  return std::visit([](const auto& d) { return vector(d.velocity); }, collider);
}

Box bounds_of(const io::ColliderScene& collider) { return std::visit(Bounds(), collider); }

Solids make_solids(const io::Scene& scene, const std::vector<double>& reach, const Box& region,
                   const PlaneDesc* ground) {
  Solids solids;
  Maker maker(region, solids);
  for (size_t i = 0; i < scene.colliders.size(); ++i) {
    const auto* plane = std::get_if<PlaneDesc>(&scene.colliders[i]);
    if (!plane || plane != ground) maker.make(scene.colliders[i], i, reach[i]);
  }
  return solids;
}

}  // namespace weft::render
