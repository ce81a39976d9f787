// Analytic colliders: a particle inside goes to the surface along the normal (Fratarcangeli 2011,
// section 22.3).
//
// Every shape is two functions: `is_inside`, and `way_out`, the shortest vector from a point inside
// to the surface. `by` is how far the collider has moved since the start of the frame.
#pragma once

#include "state/colliders.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T>
WEFT_HD bool is_inside(const Sphere<T>& s, Vec3<T> by, Vec3<T> x) {
  const Vec3<T> from = x - (s.center + by);
  return dot(from, from) < s.radius * s.radius;
}
/// The very centre leaves along +y.
template <class T>
WEFT_HD Vec3<T> way_out(const Sphere<T>& s, Vec3<T> by, Vec3<T> x) {
  const Vec3<T> center = s.center + by, from = x - center;
  const T distance = square_root(dot(from, from));
  const bool at_center = !(distance > T(0));
  const T outward = s.radius / (at_center ? T(1) : distance);
  return (center + select(at_center, Vec3<T>{T(0), s.radius, T(0)}, outward * from)) - x;
}

template <class T>
WEFT_HD bool is_inside(const Plane<T>& p, Vec3<T> by, Vec3<T> x) {
  return dot(p.normal, x) < p.offset + dot(p.normal, by);
}
template <class T>
WEFT_HD Vec3<T> way_out(const Plane<T>& p, Vec3<T> by, Vec3<T> x) {
  return (p.offset + dot(p.normal, by) - dot(p.normal, x)) * p.normal;
}

/// From the nearest point of a capsule's segment to x.
template <class T>
WEFT_HD Vec3<T> from_segment(const Capsule<T>& c, Vec3<T> by, Vec3<T> x) {
  const Vec3<T> from = x - (c.a + by);
  const T along = dot(from, c.axis) * c.inverse_length2;
  const T within = along < T(0) ? T(0) : (along > T(1) ? T(1) : along);
  return from - within * c.axis;
}
template <class T>
WEFT_HD bool is_inside(const Capsule<T>& c, Vec3<T> by, Vec3<T> x) {
  const Vec3<T> from = from_segment(c, by, x);
  return dot(from, from) < c.radius * c.radius;
}
/// A point on the axis leaves along `side`.
template <class T>
WEFT_HD Vec3<T> way_out(const Capsule<T>& c, Vec3<T> by, Vec3<T> x) {
  const Vec3<T> from = from_segment(c, by, x);
  const T distance = square_root(dot(from, from));
  const bool on_axis = !(distance > T(0));
  const T further = c.radius / (on_axis ? T(1) : distance) - T(1);
  return select(on_axis, c.radius * c.side, further * from);
}

template <class T>
WEFT_HD bool is_inside(const Cylinder<T>& c, Vec3<T> by, Vec3<T> x) {
  const Vec3<T> from = x - (c.a + by);
  const T along = dot(from, c.axis);
  const Vec3<T> across = from - along * c.axis;
  const bool above = along > T(0), below = along < c.length;
  const bool near = dot(across, across) < c.radius * c.radius;
  return above & below & near;
}
/// Through the nearest of the side and the two caps; a tie goes to the side.
template <class T>
WEFT_HD Vec3<T> way_out(const Cylinder<T>& c, Vec3<T> by, Vec3<T> x) {
  const Vec3<T> from = x - (c.a + by);
  const T along = dot(from, c.axis);
  const Vec3<T> across = from - along * c.axis;
  const T distance = square_root(dot(across, across));
  const bool on_axis = !(distance > T(0));
  const T further = c.radius / (on_axis ? T(1) : distance) - T(1);
  const Vec3<T> sideways = select(on_axis, c.radius * c.side, further * across);
  const T to_side = c.radius - distance, to_top = c.length - along;
  const T to_cap = along < to_top ? along : to_top;
  const Vec3<T> over_cap = (along < to_top ? -along : to_top) * c.axis;
  return select(to_side <= to_cap, sideways, over_cap);
}

/// Coordinates of x along the edges, from the centre.
template <class T>
WEFT_HD Vec3<T> in_box(const Box<T>& b, Vec3<T> by, Vec3<T> x) {
  const Vec3<T> from = x - (b.center + by);
  return {dot(from, b.axis[0]), dot(from, b.axis[1]), dot(from, b.axis[2])};
}
template <class T>
WEFT_HD T magnitude(T a) {
  return a < T(0) ? -a : a;
}
template <class T>
WEFT_HD bool is_inside(const Box<T>& b, Vec3<T> by, Vec3<T> x) {
  const Vec3<T> p = in_box(b, by, x);
  const bool in_x = magnitude(p.x) < b.half.x;
  const bool in_y = magnitude(p.y) < b.half.y;
  const bool in_z = magnitude(p.z) < b.half.z;
  return in_x & in_y & in_z;
}
/// Through the nearest face; of equally near ones the first, and its positive side.
template <class T>
WEFT_HD Vec3<T> way_out(const Box<T>& b, Vec3<T> by, Vec3<T> x) {
  const Vec3<T> p = in_box(b, by, x);
  const Vec3<T> depth = b.half - Vec3<T>{magnitude(p.x), magnitude(p.y), magnitude(p.z)};
  const Vec3<T> out_x = (p.x < T(0) ? -depth.x : depth.x) * b.axis[0];
  const Vec3<T> out_y = (p.y < T(0) ? -depth.y : depth.y) * b.axis[1];
  const Vec3<T> out_z = (p.z < T(0) ? -depth.z : depth.z) * b.axis[2];
  const bool y_before_z = depth.y <= depth.z;
  const Vec3<T> yz = select(y_before_z, out_y, out_z);
  const T depth_yz = y_before_z ? depth.y : depth.z;
  return select(depth.x <= depth_yz, out_x, yz);
}

/// The part of `push` that the velocity takes, as a factor in [0, 1]: all of it, unless a particle
/// would then leave along the normal faster than it came (`slip`: its displacement relative to the
/// surface's). One that rests deep inside is moved out but not thrown out (hard case 46).
template <class T>
WEFT_HD T impact_share(Vec3<T> push, Vec3<T> slip) {
  const T depth2 = dot(push, push);
  const T most = square_root(dot(slip, slip)) * square_root(depth2) - dot(push, slip);
  const T share = depth2 > T(0) ? most / depth2 : T(0);
  return share < T(0) ? T(0) : (share > T(1) ? T(1) : share);
}

/// Coulomb friction as a displacement: the tangential slip is taken back, at most by `friction`
/// times the normal displacement share * |push|. Within the cone nothing creeps.
template <class T>
WEFT_HD Vec3<T> friction_displacement(Vec3<T> push, Vec3<T> slip, T share, T friction) {
  const T depth2 = dot(push, push);
  const T normal = depth2 > T(0) ? dot(push, slip) / depth2 : T(0);
  const Vec3<T> tangential = slip - normal * push;
  const T length = square_root(dot(tangential, tangential));
  const T most = friction * (share * square_root(depth2));
  const T part = length > most ? most / length : T(1);
  return select(depth2 > T(0), (-part) * tangential, Vec3<T>{T(0), T(0), T(0)});
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
