// What a world remembers of a collider: its shape as it was described, and where that is now.
#pragma once

#include <limits>

#include "api/records/collider_motion.h"
#include "api/records/way.h"
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
  double3 point{0, 0, 0};     ///< as described: centre, foot of the axis, translation of a mesh
  double3 normal{0, 0, 0};    ///< plane
  double3 axis{0, 0, 0};      ///< capsule: from the foot to the other end; cylinder: unit vector
  double3 side{0, 0, 0};      ///< capsule, cylinder: a unit vector across the axis
  double3 edges[3] = {};      ///< box: unit vectors
  double3 half{0, 0, 0};      ///< box; mesh: of the bounds of what can touch
  double3 to_point{0, 0, 0};  ///< from the middle, which `placed` places
  double size = 0;            ///< radius; plane: offset
  double length = 0;          ///< cylinder
  double span = 0;            ///< capsule, cylinder: from end to end, as it was described last
  ColliderMesh mesh;          ///< holds the reference
  const scene::CookedColliderMesh* cooked_mesh = nullptr;
  double friction = 0;
  uint32_t layers = ~0u;
  double sweep = 0;  ///< m: who moves further in a substep is swept

  double coordinate = 0;  ///< m: the largest of those that describe it, whose rounding it has

  Placed described;           ///< of the middle; planes: of the point nearest to the world's origin
  Placed placed;              ///< at `since`
  double3 velocity{0, 0, 0};  ///< constant; none once the collider was moved
  double since = 0;           ///< s: world time
  Placed target;              ///< at the end of the next step, if `gliding`
  bool gliding = false;
  Way<Placed> way;        ///< where moves lead it
  Placed was;             ///< before the last step, if it glided in it
  bool went = false;      ///< it did
  bool can_turn = false;  ///< was ever turned by a move: it needs a column of the turns
};

inline bool may_meet(const ClothSettings& cloth, const ColliderRecord& collider) {
  return (cloth.collision_layers & collider.layers) != 0;
}

/// The path of a collider through a frame of length dt that begins at `time`. A shape or a mesh
/// turns about its middle, which goes straight.
struct ColliderPath {
  Placed begin, end;
  double3 at;  ///< of the described point at the beginning; planes: a shift of the description
  double3 velocity;  ///< m/s, of the middle
  bool turns, moves;
};
ColliderPath path_of(const ColliderRecord&, double time, double dt);
/// Where it is at the beginning.
Placed placed_at(const ColliderRecord&, double time);
/// A plane has no middle. Seen from a place, it turns about its point that is nearest to it.
ColliderPath seen_from(const double3& place, const ColliderPath&, const ColliderRecord& plane,
                       double dt);
/// dot(normal, x) = offset, at the beginning of the path.
double offset_of(const ColliderRecord& plane, const ColliderPath&);

/// Where a collider is found at any time of a frame.
struct SweptBounds {
  double3 low, high;        ///< of a box; endless for planes
  double radius = 0;        ///< m: no further than this from the box
  double3 normal{0, 0, 0};  ///< planes: below dot(normal, x) = offset
  double offset = 1;
};
/// Of what does not turn, and of every shape but the plane.
SweptBounds swept_bounds(const ColliderRecord&, const ColliderPath&);
/// Of a plane that turns, seen from near a box: as far as it concerns what is in the box.
SweptBounds swept_bounds_in(const double3& low, const double3& high, const ColliderRecord& plane,
                            const ColliderPath&);
/// Whether it comes into a box.
bool overlaps(const double3& low, const double3& high, const SweptBounds&);
/// The same of any collider, on a path through dt, as a cloth with this origin sees it.
bool comes_into(const double3& low, const double3& high, const double3& origin,
                const ColliderRecord&, const ColliderPath&, const SweptBounds&, double dt);

/// The place of a collider that was given another description, from where it is: by the shortest
/// turn. What is within the rounding of its coordinates is no turn.
Placed motion_to(const ColliderRecord&, const Placed& from, const ColliderRecord& other);
/// Throws InvalidInput where the sizes are others, by more than 1e-4 of them and four units in the
/// last place of the coordinates in float; `view` and `index` say whose they are.
void check_sizes(const ColliderRecord&, const ColliderRecord& other, const char* view,
                 uint32_t index);
bool same_sizes(const ColliderRecord&, const ColliderRecord& other);
/// Takes the sizes of another description of the same shape.
void take_sizes(ColliderRecord&, const ColliderRecord& other);

/// Each checks its description and throws InvalidInput.
ColliderRecord record_of(const SphereDesc&);
ColliderRecord record_of(const PlaneDesc&);
ColliderRecord record_of(const CapsuleDesc&);
ColliderRecord record_of(const CylinderDesc&);
ColliderRecord record_of(const BoxDesc&);
ColliderRecord record_of(const MeshColliderDesc&);

}  // namespace api
}  // namespace weft
