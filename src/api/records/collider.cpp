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
  record.layers = desc.layers;
  return record;
}

double largest(const double3& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// The description is where the collider is: nothing of it is turned.
void place(ColliderRecord& r, const double3& middle) {
  r.described.translate = middle;
  r.placed = r.described;
}

/// The vector along which a capsule or cylinder lies, from end to end.
double3 extent(const ColliderRecord& r) {
  return r.shape == ColliderShape::cylinder ? times(r.length, r.axis) : r.axis;
}
void set_least_half_width(ColliderRecord& r) {
  const double half = r.shape == ColliderShape::box ? std::min({r.half.x, r.half.y, r.half.z})
                      : r.shape == ColliderShape::cylinder ? std::min(r.size, r.length / 2)
                                                           : r.size;
  r.sweep = half / 4;
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
  set_least_half_width(r);
  r.coordinate = largest(r.point);
  place(r, r.point);
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
  r.normal = {n.x / size, n.y / size, n.z / size};
  scene::check_finite(desc.offset, "plane.offset");
  r.size = desc.offset;
  r.coordinate = std::fabs(r.size);
  r.side = across(r.normal);
  r.described.endless = true;
  place(r, times(r.size, r.normal));
  return r;
}

ColliderRecord record_of(const CapsuleDesc& desc) {
  ColliderRecord r = begin(ColliderShape::capsule, desc, "capsule.velocity", "capsule.friction");
  r.point = checked_vector(desc.a, "capsule.a");
  const double3 end = checked_vector(desc.b, "capsule.b");
  r.axis = minus(end, r.point);
  scene::check_positive(desc.radius, "capsule.radius");
  r.size = desc.radius;
  const double size = r.span = length(r.axis);
  set_least_half_width(r);
  r.to_point = times(-0.5, r.axis);
  r.coordinate = std::max(largest(r.point), largest(end));
  place(r, plus(times(0.5, r.point), times(0.5, end)));
  r.side = size > 0 ? across(times(1 / size, r.axis)) : double3{0, 1, 0};
  return r;
}

ColliderRecord record_of(const CylinderDesc& desc) {
  ColliderRecord r = begin(ColliderShape::cylinder, desc, "cylinder.velocity", "cylinder.friction");
  r.point = checked_vector(desc.a, "cylinder.a");
  const double3 end = checked_vector(desc.b, "cylinder.b");
  const double3 along = minus(end, r.point);
  scene::check_positive(desc.radius, "cylinder.radius");
  r.size = desc.radius;
  r.length = r.span = length(along);
  if (!(r.length > 0)) {
    throw InvalidInput(
        "cylinder.a and cylinder.b are the same point (a cylinder has a length) move "
        "them apart, or use a sphere");
  }
  set_least_half_width(r);
  r.to_point = times(-0.5, along);
  r.coordinate = std::max(largest(r.point), largest(end));
  place(r, plus(times(0.5, r.point), times(0.5, end)));
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
  set_least_half_width(r);
  r.coordinate = largest(r.point);
  place(r, r.point);
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
  r.mesh = desc.mesh;
  r.cooked_mesh = &desc.mesh.impl()->cooked;
  r.described = placed_by(desc.pose, "mesh.pose");
  r.described.translate = to_world(r.described, r.cooked_mesh->origin);
  r.point = r.described.translate;
  const double3 low = r.cooked_mesh->zone_low, high = r.cooked_mesh->zone_high;
  const double3 middle = plus(times(0.5, low), times(0.5, high));
  r.to_point = times(-1, middle);
  place(r, to_world(r.described, middle));
  r.half = times(0.5, minus(high, low));
  r.edges[0] = {1, 0, 0};
  r.edges[1] = {0, 1, 0};
  r.edges[2] = {0, 0, 1};
  return r;
}

namespace {

/// m: of float at a coordinate.
double float_ulp(double coordinate) {
  return coordinate > 0 ? std::ldexp(1.0, std::max(std::ilogb(coordinate), -126) - 23) : 0;
}

struct SizeCheck {
  const char* view;
  uint32_t index;
  double coordinate;

  void operator()(double size, double was, const char* what) const {
    const double most = std::max(1e-4 * was, 4 * float_ulp(coordinate));
    if (std::fabs(size - was) <= most) return;
    throw InvalidInput(
        text("%s[%u]: the %s is %g m (it was %g m: a collider moves, it does not grow) "
             "keep it, set may_stretch, or create the set anew",
             view, index, what, size, was));
  }
};

/// Whether two vectors differ by no more than the rounding of the coordinates they come from.
bool alike(const double3& a, const double3& b, double coordinate) {
  return largest(minus(a, b)) <= 4 * std::numeric_limits<double>::epsilon() * coordinate;
}
bool edges_alike(const ColliderRecord& c, const Placed& from, const ColliderRecord& other) {
  bool all = true;
  for (int e = 0; e < 3; ++e) all &= alike(rotate(from.rows, c.edges[e]), other.edges[e], 1);
  return all;
}

/// From plane to plane about the line where they meet; by more than a right angle straight across,
/// as that line can then be far from where the plane was.
Placed hinged(const ColliderRecord& c, const Placed& from, const ColliderRecord& other) {
  const double3 before = rotate(from.rows, c.normal), after = other.normal;
  const bool turns = !alike(before, after, 1);
  Placed to = from;
  if (turns) to = turned_further(turn_from_to(before, after, rotate(from.rows, c.side)), from);
  const double3& p = from.translate;
  const double off = other.size - inner(after, p), both = 1 + inner(before, after);
  const double least =
      4 * std::numeric_limits<double>::epsilon() * std::max(std::fabs(other.size), largest(p));
  if (!turns && std::fabs(off) <= least) return to;
  const double3 way = both >= 1 ? times(1 / both, plus(before, after)) : after;
  to.translate = plus(p, times(off, way));
  return to;
}

}  // namespace

void check_sizes(const ColliderRecord& c, const ColliderRecord& other, const char* view,
                 uint32_t index) {
  const SizeCheck check{view, index, std::max(c.coordinate, other.coordinate)};
  const bool round = c.shape == ColliderShape::sphere || c.shape == ColliderShape::capsule ||
                     c.shape == ColliderShape::cylinder;
  if (round) check(other.size, c.size, "radius");
  if (c.shape == ColliderShape::capsule || c.shape == ColliderShape::cylinder) {
    check(other.span, c.span, "length");
  }
  if (c.shape != ColliderShape::box) return;
  check(other.half.x, c.half.x, "half edge along x");
  check(other.half.y, c.half.y, "half edge along y");
  check(other.half.z, c.half.z, "half edge along z");
}

bool same_sizes(const ColliderRecord& c, const ColliderRecord& other) {
  if (c.shape == ColliderShape::plane) return true;
  return c.size == other.size && same(c.half, other.half) && c.span == other.span;
}

void take_sizes(ColliderRecord& c, const ColliderRecord& other) {
  if (c.shape == ColliderShape::plane) return;
  c.size = other.size;
  c.half = other.half;
  c.length = other.length;
  c.span = other.span;
  if (c.shape == ColliderShape::capsule) {
    const double now = length(c.axis), then = length(other.axis);
    // Along what it lay along; one that was a ball has a direction from now on.
    c.axis = now > 0 ? times(then / now, c.axis) : other.axis;
    if (!(now > 0) && then > 0) c.side = other.side;
  }
  c.to_point = times(-0.5, extent(c));
  c.point = plus(c.described.translate, c.to_point);
  set_least_half_width(c);
}

Placed motion_to(const ColliderRecord& c, const Placed& from, const ColliderRecord& other) {
  if (c.shape == ColliderShape::plane) return hinged(c, from, other);
  Placed to = from;
  if (c.shape == ColliderShape::capsule || c.shape == ColliderShape::cylinder) {
    const double3 before = rotate(from.rows, extent(c)), after = extent(other);
    const double long_before = length(before), long_after = length(after);
    const double coordinate = std::max(c.coordinate, other.coordinate);
    const bool turns = long_before > 0 && long_after > 0 &&
                       !alike(times(long_after / long_before, before), after, coordinate);
    if (turns) {
      const Placed turn = turn_from_to(times(1 / long_before, before), times(1 / long_after, after),
                                       rotate(from.rows, c.side));
      to = turned_further(turn, from);
    }
  } else if (c.shape == ColliderShape::box && !edges_alike(c, from, other)) {
    to = turn_of_edges(c.edges, other.edges);
  }
  to.translate = other.described.translate;
  return to;
}

ColliderPath path_of(const ColliderRecord& c, double time, double dt) {
  const double3 gone = times(time - c.since, c.velocity);
  ColliderPath path{c.placed, c.placed, {0, 0, 0}, c.velocity, false, false};
  path.begin.translate = plus(c.placed.translate, gone);
  if (same_place(c.placed, c.described)) {  // nothing of the description is rounded
    path.at = c.shape == ColliderShape::plane ? gone : plus(c.point, gone);
  } else if (c.shape != ColliderShape::plane) {
    path.at = plus(path.begin.translate, rotate(path.begin.rows, c.to_point));
  }
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

Placed placed_at(const ColliderRecord& c, double time) {
  Placed placed = c.placed;
  placed.translate = plus(placed.translate, times(time - c.since, c.velocity));
  return placed;
}

double offset_of(const ColliderRecord& c, const ColliderPath& path) {
  const double3 normal = rotate(path.begin.rows, c.normal);
  if (same_place(c.placed, c.described)) return c.size + inner(normal, path.at);
  return inner(normal, path.begin.translate);
}

ColliderPath seen_from(const double3& place, const ColliderPath& path, const ColliderRecord& c,
                       double dt) {
  ColliderPath seen = path;
  const double3 normal = rotate(path.begin.rows, c.normal);
  const double3& known = path.begin.translate;
  seen.begin.translate = plus(place, times(inner(normal, minus(known, place)), normal));
  const double3 from = minus(seen.begin.translate, known);
  // Back to the description, and out again.
  const double3 rows[3] = {{path.begin.rows[0].x, path.begin.rows[1].x, path.begin.rows[2].x},
                           {path.begin.rows[0].y, path.begin.rows[1].y, path.begin.rows[2].y},
                           {path.begin.rows[0].z, path.begin.rows[1].z, path.begin.rows[2].z}};
  seen.end.translate = plus(path.end.translate, rotate(path.end.rows, rotate(rows, from)));
  if (dt > 0) {
    seen.velocity = times(1 / dt, minus(seen.end.translate, seen.begin.translate));
  }
  return seen;
}

}  // namespace weft::api
