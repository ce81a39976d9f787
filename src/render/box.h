// Axis-aligned boxes of world points.
#pragma once

#include "weft/core.hpp"

#include <Eigen/Core>

#include <span>

namespace weft::render {

using Eigen::Vector3d;
using Eigen::Vector3f;

inline Vector3d vector(double3 v) { return {v.x, v.y, v.z}; }

/// m. Empty as long as nothing was added.
struct Box {
  Vector3d low = Vector3d::Constant(1e300), high = Vector3d::Constant(-1e300);

  bool empty() const { return !(low.array() <= high.array()).all(); }
  void add(const Vector3d& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  Vector3d center() const { return 0.5 * (low + high); }
  double radius() const { return 0.5 * (high - low).norm(); }
  /// The part of this box that is also in `other`.
  Box within(const Box& other) const {
    return {low.cwiseMax(other.low), high.cwiseMin(other.high)};
  }
  Box grown(double by) const {
    return {low - Vector3d::Constant(by), high + Vector3d::Constant(by)};
  }
  Box moved(const Vector3d& by) const { return {low + by, high + by}; }
  Vector3d nearest(const Vector3d& point) const { return point.cwiseMax(low).cwiseMin(high); }
  /// One of the eight corners, by the bits of `i`.
  Vector3d corner(int i) const {
    return {i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z()};
  }
};

inline Box box_of(std::span<const double3> points) {
  Box box;
  for (const double3& p : points) box.add(vector(p));
  return box;
}

}  // namespace weft::render
