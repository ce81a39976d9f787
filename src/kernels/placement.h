// Where a collider is during a frame, relative to where it was at its start.
#pragma once

#include "state/colliders.h"
#include "state/step.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// A collider that does not turn.
template <class T>
struct Shifted {
  Vec3<T> by;
};
/// One that turns about its pivot.
template <class T>
struct Turned {
  Mat3<T> turn;
  Vec3<T> pivot, by;
};

/// The point of the collider, as it was at the start of the frame, that is now at x.
template <class T>
WEFT_HD Vec3<T> at_start(const Shifted<T>& p, Vec3<T> x) {
  return x - p.by;
}
template <class T>
WEFT_HD Vec3<T> at_start(const Turned<T>& p, Vec3<T> x) {
  return back(p.turn, x - (p.pivot + p.by)) + p.pivot;
}
/// The reverse.
template <class T>
WEFT_HD Vec3<T> at_present(const Shifted<T>& p, Vec3<T> x) {
  return x + p.by;
}
template <class T>
WEFT_HD Vec3<T> at_present(const Turned<T>& p, Vec3<T> x) {
  return p.turn * (x - p.pivot) + (p.pivot + p.by);
}
/// A direction of the start as it is now.
template <class T>
WEFT_HD Vec3<T> turned(const Shifted<T>&, Vec3<T> v) {
  return v;
}
template <class T>
WEFT_HD Vec3<T> turned(const Turned<T>& p, Vec3<T> v) {
  return p.turn * v;
}
/// How far the collider's point that was at x has come since `before`: what sticks there goes
/// along.
template <class T>
WEFT_HD Vec3<T> carried(const Shifted<T>& before, const Shifted<T>& now, Vec3<T>) {
  return now.by - before.by;
}
template <class T>
WEFT_HD Vec3<T> carried(const Turned<T>& before, const Turned<T>& now, Vec3<T> x) {
  return at_present(now, at_start(before, x)) - x;
}

/// At the end of a substep; `ago` = 1: at its start.
template <class T>
WEFT_HD Shifted<T> shifted(const Surface<T>& s, const StepParams<T>& step, int ago) {
  return {(ago == 0 ? step.time : step.time_before) * s.velocity};
}
template <class T>
WEFT_HD Turned<T> turned(const Colliders<T>& colliders, const Surface<T>& s,
                         const StepParams<T>& step, int ago) {
  const int row = step.substep + 1 - ago;
  return {colliders.turn[int64_t(row) * colliders.turns + s.turn], s.pivot,
          shifted(s, step, ago).by};
}

/// Where the shape is now, for a look that need not turn every particle back.
template <class T>
WEFT_HD Sphere<T> at_present(const Turned<T>& p, Sphere<T> s) {
  s.center = at_present(p, s.center);
  return s;
}
template <class T>
WEFT_HD Plane<T> at_present(const Turned<T>& p, Plane<T> s) {
  const Vec3<T> normal = p.turn * s.normal;
  s.offset = s.offset - dot(s.normal, p.pivot) + dot(normal, p.pivot + p.by);
  s.normal = normal;
  return s;
}
template <class T>
WEFT_HD Capsule<T> at_present(const Turned<T>& p, Capsule<T> s) {
  s.a = at_present(p, s.a);
  s.axis = p.turn * s.axis;
  return s;
}
template <class T>
WEFT_HD Cylinder<T> at_present(const Turned<T>& p, Cylinder<T> s) {
  s.a = at_present(p, s.a);
  s.axis = p.turn * s.axis;
  return s;
}
template <class T>
WEFT_HD Box<T> at_present(const Turned<T>& p, Box<T> s) {
  s.center = at_present(p, s.center);
  for (int e = 0; e < 3; ++e) s.axis[e] = p.turn * s.axis[e];
  return s;
}
/// The same shape with something around it.
template <class T>
WEFT_HD Sphere<T> grown(Sphere<T> s, T by) {
  s.radius = s.radius + by;
  return s;
}
template <class T>
WEFT_HD Plane<T> grown(Plane<T> s, T by) {
  s.offset = s.offset + by;
  return s;
}
template <class T>
WEFT_HD Capsule<T> grown(Capsule<T> s, T by) {
  s.radius = s.radius + by;
  return s;
}
template <class T>
WEFT_HD Cylinder<T> grown(Cylinder<T> s, T by) {
  s.a = s.a - by * s.axis;
  s.length = s.length + by + by;
  s.radius = s.radius + by;
  return s;
}
template <class T>
WEFT_HD Box<T> grown(Box<T> s, T by) {
  s.half = s.half + Vec3<T>{by, by, by};
  return s;
}
/// At least the length of a vector, without a root.
template <class T>
WEFT_HD T span_of(Vec3<T> v) {
  return larger(v.x, -v.x) + larger(v.y, -v.y) + larger(v.z, -v.z);
}
/// m: no point of the shape is further from its pivot, its middle; planes: no matter.
template <class T>
WEFT_HD T size_of(const Sphere<T>& s) {
  return s.radius;
}
template <class T>
WEFT_HD T size_of(const Plane<T>&) {
  return T(0);
}
template <class T>
WEFT_HD T size_of(const Capsule<T>& s) {
  return s.radius + span_of(s.axis);
}
template <class T>
WEFT_HD T size_of(const Cylinder<T>& s) {
  return s.radius + s.length;
}
template <class T>
WEFT_HD T size_of(const Box<T>& s) {
  return span_of(s.half);
}
/// At least what the turn between two places moves a point by, over its distance from the pivot:
/// the norm of the difference of two rotations is at most its Frobenius norm over the root of two.
template <class T>
WEFT_HD T turn_between(const Turned<T>& a, const Turned<T>& b) {
  T sum = T(0);
  for (int r = 0; r < 3; ++r) sum = sum + span_of(a.turn.row[r] - b.turn.row[r]);
  return T(0.70711) * sum;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
