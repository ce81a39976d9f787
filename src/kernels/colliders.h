// Analytic colliders: a particle inside goes to the surface along the normal (Fratarcangeli 2011,
// section 22.3).
//
// Every shape is two functions: `is_inside`, and `way_out`, the shortest way from a point inside to
// the surface. Points are where the collider was at the start of the frame: kernels/placement.h
// takes them there.
#pragma once

#include "state/colliders.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T>
struct WayOut {
  Vec3<T> normal;  ///< unit vector
  T depth;
};

template <class T>
WEFT_HD bool is_inside(const Sphere<T>& s, Vec3<T> x) {
  const Vec3<T> from = x - s.center;
  return dot(from, from) < s.radius * s.radius;
}
/// Away from a centre `from` away; from so near to it that rounding decides, along `side`.
template <class T>
WEFT_HD WayOut<T> way_out_of_ball(Vec3<T> from, T radius, Vec3<T> side) {
  const T distance = square_root(dot(from, from));
  const bool at_center = !(distance > T(1e-5) * radius);
  const T scale = T(1) / (at_center ? T(1) : distance);
  return {select(at_center, side, scale * from), radius - distance};
}
/// The very centre leaves along +y.
template <class T>
WEFT_HD WayOut<T> way_out(const Sphere<T>& s, Vec3<T> x) {
  return way_out_of_ball(x - s.center, s.radius, Vec3<T>{T(0), T(1), T(0)});
}

template <class T>
WEFT_HD bool is_inside(const Plane<T>& p, Vec3<T> x) {
  return dot(p.normal, x) < p.offset;
}
template <class T>
WEFT_HD WayOut<T> way_out(const Plane<T>& p, Vec3<T> x) {
  return {p.normal, p.offset - dot(p.normal, x)};
}

/// From the nearest point of a capsule's segment to x.
template <class T>
WEFT_HD Vec3<T> from_segment(const Capsule<T>& c, Vec3<T> x) {
  const Vec3<T> from = x - c.a;
  const T along = dot(from, c.axis) * c.inverse_length2;
  const T within = larger(T(0), smaller(T(1), along));
  return from - within * c.axis;
}
template <class T>
WEFT_HD bool is_inside(const Capsule<T>& c, Vec3<T> x) {
  const Vec3<T> from = from_segment(c, x);
  return dot(from, from) < c.radius * c.radius;
}
/// A point on the axis leaves along `side`.
template <class T>
WEFT_HD WayOut<T> way_out(const Capsule<T>& c, Vec3<T> x) {
  return way_out_of_ball(from_segment(c, x), c.radius, c.side);
}

template <class T>
WEFT_HD bool is_inside(const Cylinder<T>& c, Vec3<T> x) {
  const Vec3<T> from = x - c.a;
  const T along = dot(from, c.axis);
  const Vec3<T> across = from - along * c.axis;
  const bool above = along > T(0), below = along < c.length;
  const bool near = dot(across, across) < c.radius * c.radius;
  return above & below & near;
}
/// Through the nearest of the side and the two caps; a tie goes to the side.
template <class T>
WEFT_HD WayOut<T> way_out(const Cylinder<T>& c, Vec3<T> x) {
  const Vec3<T> from = x - c.a;
  const T along = dot(from, c.axis);
  const WayOut<T> sideways = way_out_of_ball(from - along * c.axis, c.radius, c.side);
  const T to_top = c.length - along, to_cap = smaller(along, to_top);
  const bool by_side = sideways.depth <= to_cap;
  const Vec3<T> over_cap = (along < to_top ? T(-1) : T(1)) * c.axis;
  return {select(by_side, sideways.normal, over_cap), by_side ? sideways.depth : to_cap};
}

/// Coordinates of x along the edges, from the centre.
template <class T>
WEFT_HD Vec3<T> in_box(const Box<T>& b, Vec3<T> x) {
  const Vec3<T> from = x - b.center;
  return {dot(from, b.axis[0]), dot(from, b.axis[1]), dot(from, b.axis[2])};
}
template <class T>
WEFT_HD T magnitude(T a) {
  return a < T(0) ? -a : a;
}
template <class T>
WEFT_HD bool is_inside(const Box<T>& b, Vec3<T> x) {
  const Vec3<T> p = in_box(b, x);
  const bool in_x = magnitude(p.x) < b.half.x;
  const bool in_y = magnitude(p.y) < b.half.y;
  const bool in_z = magnitude(p.z) < b.half.z;
  return in_x & in_y & in_z;
}
/// Through the nearest face; of equally near ones the first, and its positive side.
template <class T>
WEFT_HD WayOut<T> way_out(const Box<T>& b, Vec3<T> x) {
  const Vec3<T> p = in_box(b, x);
  const Vec3<T> depth = b.half - Vec3<T>{magnitude(p.x), magnitude(p.y), magnitude(p.z)};
  const Vec3<T> out_x = (p.x < T(0) ? T(-1) : T(1)) * b.axis[0];
  const Vec3<T> out_y = (p.y < T(0) ? T(-1) : T(1)) * b.axis[1];
  const Vec3<T> out_z = (p.z < T(0) ? T(-1) : T(1)) * b.axis[2];
  const bool y_before_z = depth.y <= depth.z;
  const T depth_yz = y_before_z ? depth.y : depth.z;
  const bool x_first = depth.x <= depth_yz;
  return {select(x_first, out_x, select(y_before_z, out_y, out_z)), x_first ? depth.x : depth_yz};
}

/// How much of the way out of a deep overlap the velocity takes, as a displacement: what the
/// particle came in with (`across`: its displacement along the normal, relative to the surface's)
/// and no more. One that rests deep inside is moved out but not thrown out (hard case 46).
template <class T>
WEFT_HD T stopped_displacement(T depth, T across) {
  return smaller(depth, larger(T(0), -across));
}

/// Coulomb friction as a displacement: the part of a slip along the surface that is taken back, at
/// most `most` of it, which is the coefficient times the normal displacement. 1: it sticks. Within
/// the cone nothing creeps.
template <class T>
WEFT_HD T part_held(Vec3<T> along, T most) {
  const T length = square_root(dot(along, along));
  return length > most ? most / length : T(1);
}

/// Of a position, and of what is computed from it.
template <class T>
WEFT_HD T rounding_of(Vec3<T> x) {
  const T epsilon = sizeof(T) == 4 ? T(1e-6) : T(2e-15);
  return epsilon * (magnitude(x.x) + magnitude(x.y) + magnitude(x.z));
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
