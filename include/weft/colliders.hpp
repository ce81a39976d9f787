// Colliders: what cloths meet.
#pragma once

#include "weft/fabric.hpp"

namespace weft {
inline namespace v0 {

/// Rigid placement: rotate about `axis` (through the origin) by `degrees`, then translate.
struct Pose {
  double3 axis{1, 0, 0};  ///< need not be normalised; not zero unless degrees is 0
  double degrees = 0;
  double3 translate{0, 0, 0};  ///< m
};

// Colliders. A free particle inside goes to the surface along the normal; its velocity loses what
// it came in with. `friction` is the coefficient of two-sided Coulomb friction: inside the cone a
// particle sticks to the surface without creep, on it it slides. `velocity` (m/s) moves the
// collider and what sticks to it until move_collider says otherwise. A particle that moves further
// in a substep than a quarter of a collider's least half-width, relative to it, is swept: it stops
// where it enters; at a mesh in the position form, where a way that is lost would be speed, it goes
// on along the surface. What was deep inside leaves without speed. A collider that is moved turns
// about its own middle (of a mesh: of its bounds), which goes straight, by the shorter way. Cloths
// whose collision_layers have no bit of `layers` pass through it, and it wakes none of them.

/// A particle at the very centre leaves along +y.
struct SphereDesc {
  double3 center{0, 0, 0};
  double radius = 1;  ///< m, > 0
  double3 velocity{0, 0, 0};
  double friction = 0;  ///< >= 0
  uint32_t layers = ~0u;
};
/// dot(normal, x) < offset is inside.
struct PlaneDesc {
  double3 normal{0, 1, 0};  ///< normalised by weft; not zero
  double offset = 0;        ///< m, along the normalised normal
  double3 velocity{0, 0, 0};
  double friction = 0;
  uint32_t layers = ~0u;
};
/// All points nearer than `radius` to the segment from a to b, which may be one point.
struct CapsuleDesc {
  double3 a{0, 0, 0}, b{0, 1, 0};
  double radius = 1;  ///< m, > 0
  double3 velocity{0, 0, 0};
  double friction = 0;
  uint32_t layers = ~0u;
};
/// With flat caps at a and b, which must differ. A particle leaves through the nearest of the side
/// and the caps.
struct CylinderDesc {
  double3 a{0, 0, 0}, b{0, 1, 0};
  double radius = 1;  ///< m, > 0
  double3 velocity{0, 0, 0};
  double friction = 0;
  uint32_t layers = ~0u;
};
/// Turned about its centre by `degrees` about `axis`. A particle leaves through the nearest face.
struct BoxDesc {
  double3 center{0, 0, 0};
  double3 half{1, 1, 1};  ///< m, half the edges, each > 0
  double3 axis{1, 0, 0};  ///< need not be normalised; not zero unless degrees is 0
  double degrees = 0;
  double3 velocity{0, 0, 0};
  double friction = 0;
  uint32_t layers = ~0u;
};

/// Triangles of a ColliderMesh, placed by `pose`. A particle stays `thickness` away from them: on
/// the side where it is or, when the mesh is closed, outside.
struct MeshColliderDesc {
  ColliderMesh mesh;
  Pose pose;
  double3 velocity{0, 0, 0};
  double friction = 0;
  uint32_t layers = ~0u;
};
/// How a collider gets to a new place: along the way, with a velocity that contact takes up, or at
/// once, with none.
enum class Move : uint8_t { simulate, teleport };

/// The colliders of a character, sent whole every frame. The order is their identity: element i of
/// `spheres` moves from where it was to where it is now, swept and with the velocity of that move.
struct ColliderSetDesc {
  View<SphereDesc> spheres;
  View<PlaneDesc> planes;
  View<CapsuleDesc> capsules;
  View<CylinderDesc> cylinders;
  View<BoxDesc> boxes;
  /// move_collider_set: radii, lengths and edges may change. The new ones count from the beginning
  /// of the next step, all of them at once: what they newly cover is inside, and is moved out like
  /// what a teleport covers.
  bool may_stretch = false;
};

}  // namespace v0
}  // namespace weft
