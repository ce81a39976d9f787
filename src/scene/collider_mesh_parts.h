// The parts of cook_collider_mesh.
#pragma once

#include "base/host_memory.h"
#include "base/vec3.h"
#include "scene/collider_mesh.h"

namespace weft::scene {

using Point = Vec3<double>;

inline double length(Point a) { return WEFT_BACKEND_NS::square_root(WEFT_BACKEND_NS::dot(a, a)); }
/// Of a kept triangle.
Point corner_of(const CookedColliderMesh&, uint32_t triangle, int corner);
Point normal_of(const CookedColliderMesh&, uint32_t triangle);

/// The nearest point of a triangle to x, and where it lies: -1 in the face, 0 to 2 on an edge
/// (corner i to corner i + 1), 3 to 5 on a corner.
struct NearestPoint {
  Point point;
  int feature;
};
NearestPoint nearest_point(const double* corners, Point x);

/// Vertices in one place have one number: that of the first of them.
Vector<uint32_t> weld(const Vector<double3>& positions);

/// Checks that the triangles, of welded vertices, enclose something; `vertex` holds 3 of the
/// caller's numbers per triangle.
void check_closed(const Vector<double3>& positions, const Vector<uint32_t>& welded,
                  const Vector<uint32_t>& vertex);
/// Fills `sides`; `vertex` holds those of the kept triangles.
void set_sides(const Vector<uint32_t>& welded, const Vector<uint32_t>& vertex,
               CookedColliderMesh&);

/// Fills the grid and its lists.
void build_grid(CookedColliderMesh&);

}  // namespace weft::scene
