// Colliders in a cloth's own frame, at the start of a frame, with their velocities.
#pragma once

#include "base/view.h"

namespace weft {

template <class T>
struct Sphere {
  Vec3<T> center, velocity;
  T radius;
};
/// dot(normal, x) < offset is inside; `speed` is the rate of the offset.
template <class T>
struct Plane {
  Vec3<T> normal;
  T offset, speed;
};

template <class T>
struct Colliders {
  const Sphere<T>* spheres;
  const Plane<T>* planes;
};

}  // namespace weft
