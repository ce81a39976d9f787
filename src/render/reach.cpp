#include "render/reach.h"

#include "render/box.h"
#include "render/solids.h"
#include "render/weave.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace weft::render {
namespace {

struct Inside {
  Vector3d point;               ///< where it was at the start, seen from the collider
  const Eigen::Matrix3d& turn;  ///< of a box

  Depth operator()(const SphereDesc& d) const { return below(d.radius, point - vector(d.center)); }
  Depth operator()(const CapsuleDesc& d) const {
    const Vector3d a = vector(d.a), along = vector(d.b) - a;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0 ? along.dot(point - a) / length2 : 0;
    return below(d.radius, point - (a + std::clamp(t, 0.0, 1.0) * along));
  }
  Depth operator()(const CylinderDesc& d) const {
    const Vector3d half = 0.5 * (vector(d.b) - vector(d.a)), axis = half.normalized();
    const Vector3d from = point - vector(d.a) - half;
    const double up = from.dot(axis);
    const Depth side = below(d.radius, from - up * axis);
    const double end = half.norm() - std::abs(up);
    return side.value <= end ? side : Depth{end, up > 0 ? Vector3d(-axis) : axis};
  }
  Depth operator()(const BoxDesc& d) const {
    const Vector3d from = turn.transpose() * (point - vector(d.center));
    Eigen::Index side = 0;
    const double value = (vector(d.half) - from.cwiseAbs()).minCoeff(&side);
    return {value, from[side] > 0 ? Vector3d(-turn.col(side)) : Vector3d(turn.col(side))};
  }
  Depth operator()(const PlaneDesc&) const { return {}; }
  Depth operator()(const io::MeshColliderScene&) const { return {}; }

 private:
  static Depth below(double radius, const Vector3d& from) {
    const double distance = from.norm();
    return {radius - distance, distance > 0 ? Vector3d(-from / distance) : Vector3d::Zero()};
  }
};

Eigen::Matrix3d turn_of(const io::ColliderScene& collider) {
  const auto* box = std::get_if<BoxDesc>(&collider);
  return box ? rotation(box->axis, box->degrees) : Eigen::Matrix3d::Identity();
}

bool has_depth(const io::ColliderScene& collider) {
  return !std::holds_alternative<PlaneDesc>(collider) &&
         !std::holds_alternative<io::MeshColliderScene>(collider);
}

/// The deepest point of triangles, by branch and bound: a concave function lies below each of its
/// tangents, and a tangent is highest at a corner.
class Search {
 public:
  Search(const io::ColliderScene& collider, double time)
      : moved_(velocity_of(collider) * time), turn_(turn_of(collider)), collider_(collider) {}

  Depth at(const Vector3d& point) const {
    return std::visit(Inside{point - moved_, turn_}, collider_);
  }

  /// The greater of `found` and what is the deepest in a triangle, or up to `tolerance` more.
  double deepest(const std::array<Vector3d, 3>& t, double found, double tolerance,
                 int levels = 8) const {
    const Vector3d middle = (t[0] + t[1] + t[2]) / 3;
    const Depth here = at(middle);
    double most = -1e300;
    for (const Vector3d& corner : t) {
      most = std::max(most, here.value + here.slope.dot(corner - middle));
    }
    if (!(most > found)) return found;
    if (most - here.value <= tolerance || levels == 0) return most;
    const Vector3d a = 0.5 * (t[1] + t[2]), b = 0.5 * (t[2] + t[0]), c = 0.5 * (t[0] + t[1]);
    found = deepest({a, b, c}, found, tolerance, levels - 1);
    found = deepest({t[0], c, b}, found, tolerance, levels - 1);
    found = deepest({t[1], a, c}, found, tolerance, levels - 1);
    return deepest({t[2], b, a}, found, tolerance, levels - 1);
  }

 private:
  Vector3d moved_;
  Eigen::Matrix3d turn_;
  const io::ColliderScene& collider_;
};

}  // namespace

std::optional<Depth> depth_in(const io::ColliderScene& collider, double time,
                              const Vector3d& point) {
  if (!has_depth(collider)) return std::nullopt;
  return Search(collider, time).at(point);
}

Reach::Reach(const io::Scene& scene, const io::Surface& start)
    : scene_(scene), bars_(bars(scene, start)), depths_(scene.colliders.size(), 0) {
  Box box;
  for (const double3& p : start.positions) box.add(vector(p));
  const double hair = 0.01 * box.radius();
  for (const io::ColliderScene& collider : scene.colliders) {
    const Search search(collider, 0);
    holds_start_.push_back(
        has_depth(collider) &&
        std::any_of(start.positions.begin(), start.positions.end(),
                    [&](const double3& p) { return search.at(vector(p)).value > hair; }));
  }
}

void Reach::add(const io::Surface& surface, double time) {
  std::vector<double> own(surface.positions.size());
  for (size_t i = 0; i < depths_.size(); ++i) {
    if (!has_depth(scene_.colliders[i])) continue;
    const Search search(scene_.colliders[i], time);
    for (size_t v = 0; v < own.size(); ++v) {
      own[v] = std::max(0.0, search.at(vector(surface.positions[v])).value);
    }
    double& depth = depths_[i];
    const auto add = [&](uint32_t i, uint32_t j, uint32_t k) {
      const Vector3d a = vector(surface.positions[i]), b = vector(surface.positions[j]),
                     c = vector(surface.positions[k]);
      const double corner = std::max({own[i], own[j], own[k]});
      const double tolerance = 0.02 * std::max((b - a).norm(), (c - a).norm());
      depth = search.deepest({a, b, c}, depth + corner, tolerance) - corner;
    };
    for (const auto& t : surface.triangles) add(t[0], t[1], t[2]);
    for (const auto& bar : bars_) add(bar[0], bar[1], bar[1]);
  }
}

std::vector<std::string> Reach::problems() const {
  std::vector<std::string> lines;
  for (size_t i = 0; i < depths_.size(); ++i) {
    const std::string path = "$.colliders[" + std::to_string(i) + "]: ";
    if (holds_start_[i]) {
      lines.push_back(path +
                      "shows through cloth at the start (cloth starts inside of it) move one of "
                      "them, or make it smaller");
    } else if (depths_[i] > most_given(scene_.colliders[i])) {
      lines.push_back(path +
                      "shows through cloth (it is thin for the spacing of the particles, or began "
                      "in the middle of them) give the cloth more vertices, or another start");
    }
  }
  return lines;
}

}  // namespace weft::render
