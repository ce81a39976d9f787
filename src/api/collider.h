// What a world remembers of a collider: its shape in the world, in double, at the time it was made.
#pragma once

#include "plan/effects.h"
#include "weft/world.hpp"

namespace weft::api {

struct ColliderRecord {
  ColliderId id;
  ColliderShape shape = ColliderShape::sphere;
  double3 point{0, 0, 0};  ///< centre, foot of the axis; plane: its normal
  double3 axis{0, 0, 0};   ///< capsule: to the other end; cylinder: unit vector
  double3 side{0, 0, 0};   ///< capsule, cylinder: a unit vector across the axis
  double3 edges[3] = {};   ///< box: unit vectors
  double3 half{0, 0, 0};   ///< box
  double size = 0;         ///< radius; plane: offset
  double length = 0;       ///< cylinder
  double3 velocity{0, 0, 0};
  double friction = 0;
  double since = 0;  ///< s: world time that the positions are of
};

/// Each checks its description and throws InvalidInput.
ColliderRecord record_of(const SphereDesc&);
ColliderRecord record_of(const PlaneDesc&);
ColliderRecord record_of(const CapsuleDesc&);
ColliderRecord record_of(const CylinderDesc&);
ColliderRecord record_of(const BoxDesc&);

}  // namespace weft::api
