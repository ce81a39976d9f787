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

/// The triangles of a mesh, of vertices that are one where they lie in one place.
struct Surface {
  Vector<double3> positions;  ///< by vertex as given; welded ones are where the first is
  Vector<uint32_t> welded;    ///< by vertex: the first vertex in its place
  Vector<uint32_t> vertex;    ///< 3 of the caller's numbers per triangle
  Vector<uint32_t> given;     ///< the caller's numbers of the triangles
  Vector<bool> both_ways;     ///< may be turned: given both ways round; empty when none is

  uint32_t triangles() const { return static_cast<uint32_t>(given.size()); }
  uint32_t place(uint32_t corner) const { return welded[vertex[corner]]; }
};

/// An edge of a triangle, along its direction or against it.
struct Side {
  uint32_t low, high;  ///< welded vertices
  uint32_t corner;     ///< 3 * triangle + number of the corner where the edge starts
  bool ascending;      ///< runs from low to high
  friend bool operator<(const Side& x, const Side& y) {
    return x.low != y.low     ? x.low < y.low
           : x.high != y.high ? x.high < y.high
                              : x.corner < y.corner;
  }
};
inline uint32_t next_corner(uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
/// Sorted by edge, without those of triangles that are in one place twice: they close nothing.
Vector<Side> sorted_sides(const Surface&);
/// The end of the sides that lie on the edge of side `first`.
size_t end_of_edge(const Vector<Side>&, size_t first);

/// Welds the vertices of `positions` as ColliderMeshDesc::weld_distance says; `indices` are of
/// triangles. Each triangle once; `diagnostics` tells of the others.
Surface make_surface(Vector<double3> positions, const Vector<uint32_t>& indices,
                     double weld_distance, bool closed, Vector<CookedDiagnostic>& diagnostics);

/// Checks that every edge has two triangles, and every piece its inside where it should be. Turns
/// pieces whose triangles are all given both ways; true when it turned one.
bool check_closed(Surface&);
/// Fills `sides` of the kept triangles, which are those of the surface.
void set_sides(const Surface&, CookedColliderMesh&);

/// Fills the grid and its lists.
void build_grid(CookedColliderMesh&);

}  // namespace weft::scene
