// Colliders in a cloth's own frame, at the start of a frame, with their motion in it.
#pragma once

#include "base/view.h"
#include "state/collider_mesh.h"
#include "state/counts.h"

namespace weft {

enum class ColliderShape : int32_t { sphere, plane, capsule, cylinder, box, mesh };
constexpr int collider_shapes = 6;

/// What every collider has. During a frame it is shifted by velocity * time and, if it turns,
/// turned about its pivot: x = turn (start - pivot) + pivot + velocity * time.
template <class T>
struct Surface {
  Vec3<T> velocity;  ///< m/s, of the pivot
  T friction;        ///< coefficient of Coulomb friction
  T sweep;           ///< m: who moves further in a substep is swept
  int32_t turn;      ///< its column in Colliders::turn; -1: it does not turn
  Vec3<T> pivot;
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
/// Triangles in a frame of their own: x = rotation * p + translate.
template <class T>
struct MeshCollider {
  TriangleGrid<T> grid;
  Mat3<T> rotation;
  Vec3<T> translate;
  Surface<T> surface;
};

/// Where a collider can be in this frame: no further than a radius from a box, and below the plane
/// dot(normal, x) = offset. What does not limit a shape is endless; a normal of 0 goes with an
/// offset of 1.
template <class T>
struct ColliderBounds {
  Vec3<T> low, high;
  T radius2;
  Vec3<T> normal;
  T offset;
};

template <class T>
struct Colliders {
  const Sphere<T>* spheres;
  const Plane<T>* planes;
  const Capsule<T>* capsules;
  const Cylinder<T>* cylinders;
  const Box<T>* boxes;
  const MeshCollider<T>* meshes;
  const Mat3<T>* turn;  ///< [substep + 1][column]: since the start of the frame, row 0: not at all
  int turns;            ///< columns
  const int32_t* near;  ///< lists of ClothActivity: index among those of a shape
  const ColliderBounds<T>* near_bounds;  ///< of the entries of `near`

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    const auto of = [&n](ColliderShape shape) {
      return n.cloths * n.colliders[static_cast<int>(shape)];
    };
    array(spheres, of(ColliderShape::sphere));
    array(planes, of(ColliderShape::plane));
    array(capsules, of(ColliderShape::capsule));
    array(cylinders, of(ColliderShape::cylinder));
    array(boxes, of(ColliderShape::box));
    array(meshes, of(ColliderShape::mesh));
    array(turn, n.turns * (n.substeps + 1));
    array.number(turns, n.turns);
    array(near, n.cloths * n.all_colliders);
    array(near_bounds, n.cloths * n.all_colliders);
  }
};

}  // namespace weft
