// Where a collider is found at any time of a frame, and whether that comes into a box.
#include <algorithm>
#include <cmath>
#include <limits>

#include "api/records/collider.h"

namespace weft::api {

namespace {

/// Half the edges of the box along the world's axes about a collider's middle, and what is rounded
/// about it.
double3 half_of(const ColliderRecord& c, const Placed& placed) {
  const auto size = [](const double3& v) {
    return double3{std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
  };
  if (c.shape == ColliderShape::sphere) return {0, 0, 0};
  if (c.shape == ColliderShape::box || c.shape == ColliderShape::mesh) {
    const double sizes[3] = {c.half.x, c.half.y, c.half.z};
    double3 half{0, 0, 0};
    for (int e = 0; e < 3; ++e) {
      half = plus(half, times(sizes[e], size(rotate(placed.rows, c.edges[e]))));
    }
    return half;
  }
  const double3 half = size(rotate(placed.rows, c.to_point));
  if (c.shape == ColliderShape::capsule) return half;
  // A disc across a unit vector n is size sqrt(1 - n_i^2) wide along axis i.
  const double3 n = rotate(placed.rows, c.axis);
  const auto wide = [&](double along) {
    return c.size * std::sqrt(std::max(0.0, 1 - along * along));
  };
  return plus(half, {wide(n.x), wide(n.y), wide(n.z)});
}
double rounded_by(const ColliderRecord& c) {
  const bool round = c.shape == ColliderShape::sphere || c.shape == ColliderShape::capsule;
  return round ? c.size : 0;
}

double3 larger_of(const double3& a, const double3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
double3 smaller_of(const double3& a, const double3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

/// m: how far from the middle a collider has something that a turn takes along.
double reach_of(const ColliderRecord& c) {
  switch (c.shape) {
    case ColliderShape::sphere:
    case ColliderShape::plane:
      return 0;
    case ColliderShape::capsule:
      return length(c.axis) / 2;
    case ColliderShape::cylinder:
      return std::sqrt(c.length * c.length / 4 + c.size * c.size);
    case ColliderShape::box:
    case ColliderShape::mesh:
      break;
  }
  return length(c.half);
}

SweptBounds half_space() {
  const double endless = std::numeric_limits<double>::infinity();
  SweptBounds bounds;
  bounds.low = {-endless, -endless, -endless};
  bounds.high = {endless, endless, endless};
  return bounds;
}

SweptBounds swept_bounds_of_plane(const ColliderRecord& c, const ColliderPath& path) {
  SweptBounds bounds = half_space();
  if (path.turns) return bounds;
  bounds.normal = rotate(path.begin.rows, c.normal);
  const double on = inner(bounds.normal, minus(path.end.translate, path.begin.translate));
  bounds.offset = offset_of(c, path) + std::max(0.0, on);
  return bounds;
}

}  // namespace

/// A point goes along an arc, which leaves its chord by radius (1 - cos(angle / 2)) at most, while
/// the middle goes straight. All shapes are symmetric about their middles.
SweptBounds swept_bounds(const ColliderRecord& c, const ColliderPath& path) {
  if (c.shape == ColliderShape::plane) return swept_bounds_of_plane(c, path);
  const double3 &begin = path.begin.translate, &end = path.end.translate;
  double3 half = half_of(c, path.begin);
  if (path.turns && c.shape != ColliderShape::sphere) {
    const double rise = reach_of(c) * (1 - half_turn_cosine(path.begin, path.end));
    half = plus(larger_of(half, half_of(c, path.end)), {rise, rise, rise});
  }
  SweptBounds bounds;
  bounds.low = minus(smaller_of(begin, end), half);
  bounds.high = plus(larger_of(begin, end), half);
  bounds.radius = rounded_by(c);
  return bounds;
}

/// With the unit normals n(t) and the pivot p + t by: n(0).(x - p) is at most n(t).(x - p) +
/// |n(t) - n(0)| |x - p|, and what is below the plane has n(t).(x - p) < t n(t).by.
SweptBounds swept_bounds_in(const double3& low, const double3& high, const ColliderRecord& c,
                            const ColliderPath& path) {
  SweptBounds bounds = half_space();
  const double3& p = path.begin.translate;
  const double3 by = minus(path.end.translate, p);
  const double3 first = rotate(path.begin.rows, c.normal), last = rotate(path.end.rows, c.normal);
  const double rise = 1 - half_turn_cosine(path.begin, path.end);
  const double on = std::max({0.0, inner(first, by), inner(last, by)}) + rise * length(by);
  const double3 a = minus(p, low), b = minus(high, p);
  const double3 far{std::max(std::fabs(a.x), std::fabs(b.x)),
                    std::max(std::fabs(a.y), std::fabs(b.y)),
                    std::max(std::fabs(a.z), std::fabs(b.z))};
  bounds.normal = first;
  bounds.offset = inner(first, p) + on + length(minus(last, first)) * length(far);
  return bounds;
}

bool overlaps(const double3& low, const double3& high, const SweptBounds& r) {
  const double3 none{0, 0, 0};
  const double3 apart = larger_of(none, larger_of(minus(r.low, high), minus(low, r.high)));
  const double3 lowest{r.normal.x > 0 ? low.x : high.x, r.normal.y > 0 ? low.y : high.y,
                       r.normal.z > 0 ? low.z : high.z};
  return inner(apart, apart) <= r.radius * r.radius && inner(r.normal, lowest) <= r.offset;
}

bool comes_into(const double3& low, const double3& high, const double3& origin,
                const ColliderRecord& c, const ColliderPath& path, const SweptBounds& bounds,
                double dt) {
  if (c.shape != ColliderShape::plane || !path.turns) return overlaps(low, high, bounds);
  return overlaps(low, high, swept_bounds_in(low, high, c, seen_from(origin, path, c, dt)));
}

}  // namespace weft::api
