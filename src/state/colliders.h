// Colliders in a cloth's own frame, at the start of a frame, with their velocities.
#pragma once

#include "base/view.h"

namespace weft {

enum class ColliderShape : int32_t { sphere, plane, capsule, cylinder, box };
constexpr int collider_shapes = 5;

/// What every collider has.
template <class T>
struct Surface {
  Vec3<T> velocity;  ///< m/s
  T friction;        ///< coefficient of Coulomb friction
};

template <class T>
struct Sphere {
  Vec3<T> center;
  T radius;
  Surface<T> surface;
};
/// dot(normal, x) < offset is inside.
template <class T>
struct Plane {
  Vec3<T> normal;
  T offset;
  Surface<T> surface;
};
/// All points nearer than `radius` to the segment from `a` to a + axis.
template <class T>
struct Capsule {
  Vec3<T> a, axis;
  T inverse_length2;  ///< 1 / |axis|^2; 0 for a capsule that is a sphere
  T radius;
  Vec3<T> side;  ///< a unit vector across the axis: the way out for a point on it
  Surface<T> surface;
};
/// Capped: both ends are flat.
template <class T>
struct Cylinder {
  Vec3<T> a, axis;  ///< foot, unit vector
  T length, radius;
  Vec3<T> side;
  Surface<T> surface;
};
template <class T>
struct Box {
  Vec3<T> center, axis[3];  ///< unit vectors along the edges
  Vec3<T> half;             ///< half the length of the edges
  Surface<T> surface;
};

template <class T>
struct Colliders {
  const Sphere<T>* spheres;
  const Plane<T>* planes;
  const Capsule<T>* capsules;
  const Cylinder<T>* cylinders;
  const Box<T>* boxes;
};

}  // namespace weft
