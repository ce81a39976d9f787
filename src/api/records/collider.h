// What a world remembers of a collider: its shape as it was described, and where that is now.
#pragma once

#include <limits>

#include "api/records/collider_motion.h"
#include "plan/shape.h"
#include "weft/world.hpp"

namespace weft {
namespace scene {
struct CookedColliderMesh;
}
namespace api {

struct ColliderRecord {
  ColliderId id;
  ColliderShape shape = ColliderShape::sphere;
  // As described.
  double3 point{0, 0, 0};  ///< centre, foot of the axis; plane: its normal
  double3 axis{0, 0, 0};   ///< capsule: to the other end; cylinder: unit vector
  double3 side{0, 0, 0};   ///< capsule, cylinder: a unit vector across the axis
  double3 edges[3] = {};   ///< box: unit vectors
  double3 half{0, 0, 0};   ///< box; mesh: of the bounds of what can touch
  double size = 0;         ///< radius; plane: offset
  double length = 0;       ///< cylinder
  ColliderMesh mesh;       ///< holds the reference
  const scene::CookedColliderMesh* cooked_mesh = nullptr;
  double friction = 0;
  double sweep = 0;  ///< m: who moves further in a substep is swept

  Placed described;           ///< mesh: its pose in the description
  Placed placed;              ///< at `since`
  double3 velocity{0, 0, 0};  ///< constant; none once the collider was moved
  double since = 0;           ///< s: world time
  Placed target;              ///< at the end of the next step, if `gliding`
  bool gliding = false;
  Placed was;             ///< before the last step, if it glided in it
  bool went = false;      ///< it did
  bool can_turn = false;  ///< was ever turned by a move: it needs a column of the turns
};

/// The path of a collider through a frame of length dt that begins at `time`.
struct ColliderPath {
  Placed begin, end;
  double3 velocity;  ///< m/s, of the pivot, begin.translate
  bool turns, moves;
};
ColliderPath path_of(const ColliderRecord&, double time, double dt);

/// Where the collider is found at any time of a frame.
struct SweptBounds {
  double3 low, high;        ///< endless for planes
  double3 center{0, 0, 0};  ///< spheres: of a ball that holds all of the path
  double radius = std::numeric_limits<double>::infinity();
  double3 normal{0, 0, 0};  ///< planes that do not turn: below dot(normal, x) = offset
  double offset = 1;
};
SweptBounds swept_bounds(const ColliderRecord&, const ColliderPath&);
/// Whether it comes into a box.
bool overlaps(const double3& low, const double3& high, const SweptBounds&);

/// The motion that takes a collider as it was described to another description of it. Throws
/// InvalidInput where no rigid motion does; `name` says whose it is.
Placed motion_to(const ColliderRecord&, const ColliderRecord& other, const char* name);

/// Each checks its description and throws InvalidInput.
ColliderRecord record_of(const SphereDesc&);
ColliderRecord record_of(const PlaneDesc&);
ColliderRecord record_of(const CapsuleDesc&);
ColliderRecord record_of(const CylinderDesc&);
ColliderRecord record_of(const BoxDesc&);
ColliderRecord record_of(const MeshColliderDesc&);

}  // namespace api
}  // namespace weft
