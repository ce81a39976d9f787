// Swept test: where the way of a particle, a straight line from p0 to p1, enters a shape.
// Continuous collision of a moving point with a body at rest: the caller takes both ends to the
// collider's frame.
#pragma once

#include "kernels/colliders.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// p0 + time (p1 - p0) is where the way enters; above 1: it does not, or it began inside.
template <class T>
struct Entry {
  T time;
  T within;        ///< how long it is inside, where the line goes on
  Vec3<T> normal;  ///< of the surface there
};

template <class T>
WEFT_HD Entry<T> earlier(Entry<T> a, Entry<T> b) {
  const bool first = a.time <= b.time;
  return {first ? a.time : b.time, first ? a.within : b.within, select(first, a.normal, b.normal)};
}
template <class T>
WEFT_HD T magnitude2(Vec3<T> v) {
  return dot(v, v);
}
/// 2, which no way reaches, unless `valid`.
template <class T>
WEFT_HD T time_if(bool valid, T time) {
  return valid ? time : T(2);
}

/// Ball about the origin. The closest approach is taken first: b^2 - ac would cancel.
template <class T>
WEFT_HD Entry<T> entry_of_ball(Vec3<T> p0, Vec3<T> way, T radius) {
  const T length2 = magnitude2(way);
  const bool moves = length2 > T(0);
  const T closest = moves ? -(dot(p0, way) / length2) : T(0);
  const Vec3<T> miss = p0 + closest * way;
  const T inside2 = radius * radius - magnitude2(miss);
  const T half = square_root((inside2 > T(0) ? inside2 : T(0)) / (moves ? length2 : T(1)));
  const T time = closest - half;
  const bool valid = moves & (inside2 > T(0)) & (time >= T(0)) & (time <= T(1));
  const Vec3<T> at = p0 + time * way;
  return {time_if(valid, time), half + half, (T(1) / radius) * at};
}

/// The times at which the way is within |p| <= half along one direction.
template <class T>
struct Slab {
  T enters, leaves, side;  ///< side: -1 or +1, the face it enters by
};
template <class T>
WEFT_HD Slab<T> slab(T p, T way, T half) {
  const bool moves = magnitude(way) > T(0), within = magnitude(p) < half;
  const T speed = moves ? way : T(1);
  const T a = (-half - p) / speed, b = (half - p) / speed;
  const T never = T(4), ever = T(-4);
  return {moves ? smaller(a, b) : (within ? ever : never),
          moves ? larger(a, b) : (within ? never : ever), way > T(0) ? T(-1) : T(1)};
}

template <class T>
WEFT_HD Entry<T> entry(const Sphere<T>& s, Vec3<T> p0, Vec3<T> p1) {
  return entry_of_ball(p0 - s.center, p1 - p0, s.radius);
}

template <class T>
WEFT_HD Entry<T> entry(const Box<T>& b, Vec3<T> p0, Vec3<T> p1) {
  const Vec3<T> p = in_box(b, p0), end = in_box(b, p1), way = end - p;
  const Slab<T> x = slab(p.x, way.x, b.half.x), y = slab(p.y, way.y, b.half.y),
                z = slab(p.z, way.z, b.half.z);
  const T enters = larger(x.enters, larger(y.enters, z.enters));
  const T leaves = smaller(x.leaves, smaller(y.leaves, z.leaves));
  const bool valid = (enters >= T(0)) & (enters <= T(1)) & (enters < leaves);
  const bool by_x = x.enters >= enters, by_y = y.enters >= enters;
  const Vec3<T> normal =
      select(by_x, x.side * b.axis[0], select(by_y, y.side * b.axis[1], z.side * b.axis[2]));
  return {time_if(valid, enters), leaves - enters, normal};
}

/// The part of the way within an endless cylinder about `axis`, a unit vector, through the origin.
template <class T>
WEFT_HD Slab<T> tube(Vec3<T> across0, Vec3<T> across_way, T radius) {
  const T length2 = magnitude2(across_way);
  const bool moves = length2 > T(0), within = magnitude2(across0) < radius * radius;
  const T closest = moves ? -(dot(across0, across_way) / length2) : T(0);
  const T inside2 = radius * radius - magnitude2(across0 + closest * across_way);
  const T half = square_root((inside2 > T(0) ? inside2 : T(0)) / (moves ? length2 : T(1)));
  const bool hits = moves ? inside2 > T(0) : within;
  const T never = T(4), ever = T(-4);
  const bool crosses = moves & hits;
  return {crosses ? closest - half : (hits ? ever : never),
          crosses ? closest + half : (hits ? never : ever), T(0)};
}

template <class T>
WEFT_HD Entry<T> entry(const Cylinder<T>& c, Vec3<T> p0, Vec3<T> p1) {
  const Vec3<T> from = p0 - c.a, way = p1 - p0;
  const T along = dot(from, c.axis), along_way = dot(way, c.axis);
  const Vec3<T> across = from - along * c.axis, across_way = way - along_way * c.axis;
  const Slab<T> side = tube(across, across_way, c.radius);
  const T half = T(0.5) * c.length;
  const Slab<T> caps = slab(along - half, along_way, half);
  const T enters = larger(side.enters, caps.enters), leaves = smaller(side.leaves, caps.leaves);
  const bool valid = (enters >= T(0)) & (enters <= T(1)) & (enters < leaves);
  const Vec3<T> outward = (T(1) / c.radius) * (across + enters * across_way);
  return {time_if(valid, enters), leaves - enters,
          select(side.enters >= caps.enters, outward, caps.side * c.axis)};
}

template <class T>
WEFT_HD Entry<T> entry(const Capsule<T>& c, Vec3<T> p0, Vec3<T> p1) {
  const Vec3<T> from = p0 - c.a, way = p1 - p0;
  const Entry<T> ends =
      earlier(entry_of_ball(from, way, c.radius), entry_of_ball(from - c.axis, way, c.radius));
  // Along the axis in units of its length; a capsule that is a sphere has no side.
  const T along = dot(from, c.axis) * c.inverse_length2;
  const T along_way = dot(way, c.axis) * c.inverse_length2;
  const Vec3<T> across = from - along * c.axis, across_way = way - along_way * c.axis;
  const Slab<T> side = tube(across, across_way, c.radius);
  const T at = along + side.enters * along_way;
  const bool valid = (c.inverse_length2 > T(0)) & (side.enters >= T(0)) & (side.enters <= T(1)) &
                     (at > T(0)) & (at < T(1));
  const Vec3<T> outward = (T(1) / c.radius) * (across + side.enters * across_way);
  return earlier(ends, Entry<T>{time_if(valid, side.enters), side.leaves - side.enters, outward});
}

/// Whether a shape can be passed through.
template <class Shape>
struct IsSwept {
  static constexpr bool value = true;
};
template <class T>
struct IsSwept<Plane<T>> {
  static constexpr bool value = false;
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
