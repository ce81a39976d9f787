#include "api/collider.h"

#include "api/vector_math.h"
#include "base/message_host.h"
#include "scene/check.h"

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
  double3 rows[3];
  rotation_rows(desc.axis, desc.degrees, "box", rows);
  // The edges are the columns of the rotation.
  r.edges[0] = {rows[0].x, rows[1].x, rows[2].x};
  r.edges[1] = {rows[0].y, rows[1].y, rows[2].y};
  r.edges[2] = {rows[0].z, rows[1].z, rows[2].z};
  return r;
}

}  // namespace weft::api
