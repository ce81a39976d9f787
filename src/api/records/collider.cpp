#include "api/records/collider.h"

#include <algorithm>
#include <limits>

#include "api/context/context_state.h"
#include "scene/check.h"
#include "scene/collider_mesh.h"

namespace weft::api {

namespace {

template <class Desc>
ColliderRecord begin(ColliderShape shape, const Desc& desc, const char* velocity,
                     const char* friction) {
  ColliderRecord record;
  record.shape = shape;
  record.velocity = checked_vector(desc.velocity, velocity);
  scene::check_not_negative(desc.friction, friction);
  record.friction = desc.friction;
  return record;
}

/// A unit vector across a unit vector, away from its largest component.
double3 across(const double3& axis) {
  const double x = std::fabs(axis.x), y = std::fabs(axis.y), z = std::fabs(axis.z);
  const double3 other = x <= y && x <= z ? double3{1, 0, 0}
                        : y <= z         ? double3{0, 1, 0}
                                         : double3{0, 0, 1};
  const double3 v = outer(axis, other);
  return times(1 / length(v), v);
}

}  // namespace

ColliderRecord record_of(const SphereDesc& desc) {
  ColliderRecord r = begin(ColliderShape::sphere, desc, "sphere.velocity", "sphere.friction");
  r.point = checked_vector(desc.center, "sphere.center");
  scene::check_positive(desc.radius, "sphere.radius");
  r.size = desc.radius;
  r.sweep = r.size / 4;
  return r;
}

ColliderRecord record_of(const PlaneDesc& desc) {
  ColliderRecord r = begin(ColliderShape::plane, desc, "plane.velocity", "plane.friction");
  const double3 n = checked_vector(desc.normal, "plane.normal");
  const double size = length(n);
  if (!(size > 0) || !std::isfinite(size)) {
    throw InvalidInput(
        text("plane.normal is (%g, %g, %g) (it has no direction) give a vector of "
             "ordinary length",
             n.x, n.y, n.z));
  }
  r.point = {n.x / size, n.y / size, n.z / size};
  scene::check_finite(desc.offset, "plane.offset");
  r.size = desc.offset;
  return r;
}

ColliderRecord record_of(const CapsuleDesc& desc) {
  ColliderRecord r = begin(ColliderShape::capsule, desc, "capsule.velocity", "capsule.friction");
  r.point = checked_vector(desc.a, "capsule.a");
  r.axis = minus(checked_vector(desc.b, "capsule.b"), r.point);
  scene::check_positive(desc.radius, "capsule.radius");
  r.size = desc.radius;
  const double size = length(r.axis);
  r.sweep = r.size / 4;
  r.side = size > 0 ? across(times(1 / size, r.axis)) : double3{0, 1, 0};
  return r;
}

ColliderRecord record_of(const CylinderDesc& desc) {
  ColliderRecord r = begin(ColliderShape::cylinder, desc, "cylinder.velocity", "cylinder.friction");
  r.point = checked_vector(desc.a, "cylinder.a");
  const double3 along = minus(checked_vector(desc.b, "cylinder.b"), r.point);
  scene::check_positive(desc.radius, "cylinder.radius");
  r.size = desc.radius;
  r.length = length(along);
  if (!(r.length > 0)) {
    throw InvalidInput(
        "cylinder.a and cylinder.b are the same point (a cylinder has a length) move "
        "them apart, or use a sphere");
  }
  r.sweep = std::min(r.size, r.length / 2) / 4;
  r.axis = times(1 / r.length, along);
  r.side = across(r.axis);
  return r;
}

ColliderRecord record_of(const BoxDesc& desc) {
  ColliderRecord r = begin(ColliderShape::box, desc, "box.velocity", "box.friction");
  r.point = checked_vector(desc.center, "box.center");
  scene::check_positive(desc.half.x, "box.half.x");
  scene::check_positive(desc.half.y, "box.half.y");
  scene::check_positive(desc.half.z, "box.half.z");
  r.half = desc.half;
  r.sweep = std::min({r.half.x, r.half.y, r.half.z}) / 4;
  double3 rows[3];
  rotation_rows(desc.axis, desc.degrees, "box", rows);
  // The edges are the columns of the rotation.
  r.edges[0] = {rows[0].x, rows[1].x, rows[2].x};
  r.edges[1] = {rows[0].y, rows[1].y, rows[2].y};
  r.edges[2] = {rows[0].z, rows[1].z, rows[2].z};
  return r;
}

ColliderRecord record_of(const MeshColliderDesc& desc) {
  ColliderRecord r = begin(ColliderShape::mesh, desc, "mesh.velocity", "mesh.friction");
  if (desc.mesh.triangle_count() == 0) {
    throw InvalidInput(
        "mesh.mesh is empty (there is nothing to collide with) cook a ColliderMesh first");
  }
  r.described = r.placed = placed_by(desc.pose, "mesh.pose");
  r.mesh = desc.mesh;
  r.cooked_mesh = &desc.mesh.impl()->cooked;
  const double3 low = r.cooked_mesh->zone_low, high = r.cooked_mesh->zone_high;
  r.point = times(0.5, plus(low, high));
  r.half = times(0.5, minus(high, low));
  r.edges[0] = {1, 0, 0};
  r.edges[1] = {0, 1, 0};
  r.edges[2] = {0, 0, 1};
  return r;
}

static void check_size(double size, double was, const char* name, const char* what) {
  if (std::fabs(size - was) <= 1e-4 * was) return;
  throw InvalidInput(
      text("%s: the %s is %g m (it was %g m: a collider moves, it does not grow) "
           "keep it, or create the set anew",
           name, what, size, was));
}

Placed motion_to(const ColliderRecord& c, const ColliderRecord& other, const char* name) {
  const double size = length(c.axis), size_other = length(other.axis);
  Placed to;
  switch (c.shape) {
    case ColliderShape::sphere:
      check_size(other.size, c.size, name, "radius");
      break;
    case ColliderShape::plane:
      to = turn_from_to(c.point, other.point, across(c.point));
      to.translate = times(other.size - c.size, other.point);
      return to;
    case ColliderShape::capsule:
      check_size(other.size, c.size, name, "radius");
      check_size(size_other, size, name, "length");
      if (size > 0) {
        to = turn_from_to(times(1 / size, c.axis), times(1 / size_other, other.axis), c.side);
      }
      break;
    case ColliderShape::cylinder:
      check_size(other.size, c.size, name, "radius");
      check_size(other.length, c.length, name, "length");
      to = turn_from_to(c.axis, other.axis, c.side);
      break;
    case ColliderShape::box:
      check_size(other.half.x, c.half.x, name, "half edge along x");
      check_size(other.half.y, c.half.y, name, "half edge along y");
      check_size(other.half.z, c.half.z, name, "half edge along z");
      to = turn_of_edges(c.edges, other.edges);
      break;
    case ColliderShape::mesh:
      break;
  }
  to.translate = minus(other.point, rotate(to.rows, c.point));
  return to;
}

ColliderPath path_of(const ColliderRecord& c, double time, double dt) {
  ColliderPath path{c.placed, c.placed, c.velocity, false, false};
  path.begin.translate = plus(c.placed.translate, times(time - c.since, c.velocity));
  if (c.gliding) {
    path.end = c.target;
    path.velocity =
        dt > 0 ? times(1 / dt, minus(c.target.translate, path.begin.translate)) : double3{0, 0, 0};
    path.turns = !same_rotation(path.begin, path.end);
  } else {
    path.end.translate = plus(path.begin.translate, times(dt, c.velocity));
  }
  const double3 by = path.velocity;
  path.moves = path.turns || by.x != 0 || by.y != 0 || by.z != 0;
  return path;
}

namespace {

struct Ball {
  double3 center;  ///< as described
  double radius;
};
/// A ball about the collider's origin as described would not be tight; this one is about its
/// middle.
Ball ball_around(const ColliderRecord& c) {
  switch (c.shape) {
    case ColliderShape::sphere:
      return {c.point, c.size};
    case ColliderShape::capsule:
      return {plus(c.point, times(0.5, c.axis)), length(c.axis) / 2 + c.size};
    case ColliderShape::cylinder:
      return {plus(c.point, times(c.length / 2, c.axis)), c.length / 2 + c.size};
    case ColliderShape::box:
    case ColliderShape::mesh:
      return {c.point, length(c.half)};
    case ColliderShape::plane:
      break;
  }
  return {{0, 0, 0}, std::numeric_limits<double>::infinity()};
}

/// Half the edges of the box along the world's axes about a collider's middle.
double3 half_of(const ColliderRecord& c, const Placed& placed) {
  const auto part = [](double along, double size) { return std::fabs(along) + size; };
  double3 half{0, 0, 0};
  if (c.shape == ColliderShape::box || c.shape == ColliderShape::mesh) {
    const double sizes[3] = {c.half.x, c.half.y, c.half.z};
    for (int e = 0; e < 3; ++e) {
      const double3 edge = rotate(placed.rows, c.edges[e]);
      half = plus(half, times(sizes[e], {std::fabs(edge.x), std::fabs(edge.y), std::fabs(edge.z)}));
    }
    return half;
  }
  const double along = c.shape == ColliderShape::capsule    ? 0.5
                       : c.shape == ColliderShape::cylinder ? c.length / 2
                                                            : 0;
  const double3 axis = times(along, rotate(placed.rows, c.axis));
  return {part(axis.x, c.size), part(axis.y, c.size), part(axis.z, c.size)};
}

SweptBounds swept_bounds_of_plane(const ColliderRecord& c, const ColliderPath& path) {
  const double endless = std::numeric_limits<double>::infinity();
  SweptBounds bounds;
  bounds.low = {-endless, -endless, -endless};
  bounds.high = {endless, endless, endless};
  if (path.turns) return bounds;
  bounds.normal = rotate(path.begin.rows, c.point);
  bounds.offset = c.size + std::max(inner(bounds.normal, path.begin.translate),
                                    inner(bounds.normal, path.end.translate));
  return bounds;
}

}  // namespace

SweptBounds swept_bounds(const ColliderRecord& c, const ColliderPath& path) {
  if (c.shape == ColliderShape::plane) return swept_bounds_of_plane(c, path);
  const Ball ball = ball_around(c);
  double3 begin = to_world(path.begin, ball.center), end = to_world(path.end, ball.center);
  double3 half = half_of(c, path.begin);
  if (path.turns) {  // anywhere on the sphere about the pivot that the farthest point is on
    const double far = length(ball.center) + ball.radius;
    half = {far, far, far};
    begin = path.begin.translate;
    end = path.end.translate;
  }
  SweptBounds bounds;
  bounds.low =
      minus({std::min(begin.x, end.x), std::min(begin.y, end.y), std::min(begin.z, end.z)}, half);
  bounds.high =
      plus({std::max(begin.x, end.x), std::max(begin.y, end.y), std::max(begin.z, end.z)}, half);
  if (c.shape == ColliderShape::sphere && !path.turns) {
    bounds.center = times(0.5, plus(begin, end));
    bounds.radius = c.size + 0.5 * length(minus(end, begin));
  }
  return bounds;
}

bool overlaps(const double3& low, const double3& high, const SweptBounds& r) {
  const bool in_box = low.x <= r.high.x && high.x >= r.low.x && low.y <= r.high.y &&
                      high.y >= r.low.y && low.z <= r.high.z && high.z >= r.low.z;
  const double3 lowest{r.normal.x > 0 ? low.x : high.x, r.normal.y > 0 ? low.y : high.y,
                       r.normal.z > 0 ? low.z : high.z};
  const double3 nearest{std::max(low.x, std::min(high.x, r.center.x)),
                        std::max(low.y, std::min(high.y, r.center.y)),
                        std::max(low.z, std::min(high.z, r.center.z))};
  return in_box && inner(r.normal, lowest) <= r.offset &&
         length(minus(nearest, r.center)) <= r.radius;
}

}  // namespace weft::api
