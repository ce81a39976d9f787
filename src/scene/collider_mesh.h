// What cooking makes of a triangle mesh that particles collide with. Host data in double.
#pragma once

#include "base/memory_host.h"
#include "scene/fabric.h"

namespace weft::scene {

/// The arrays are laid out as state/collider_mesh.h has them. Triangles that lie together have
/// numbers that do.
struct CookedColliderMesh {
  explicit CookedColliderMesh(std::pmr::memory_resource* memory)
      : cell_start(memory),
        entry_triangle(memory),
        planes(memory),
        corners(memory),
        sides(memory) {}

  uint32_t triangles = 0;  ///< that have an area
  double thickness = 0;    ///< m
  bool closed = false;
  /// Whole metres: what follows is relative to it. Zero unless the mesh lies far from its own
  /// origin, where floats would be coarse.
  double3 origin{};
  double3 zone_low{}, zone_high{};  ///< box that holds everything nearer than the thickness

  double3 grid_low{};
  double cell_size = 0;
  int32_t cells[3] = {0, 0, 0};
  Array<int32_t> cell_start;
  Array<int32_t> entry_triangle;

  Array<double> planes;   ///< 16 per triangle
  Array<double> corners;  ///< 9 per triangle
  Array<double> sides;    ///< 18 per triangle; empty unless closed

  Vector<CookedDiagnostic> diagnostics;
};

void cook_collider_mesh(const ColliderMeshDesc&, CookedColliderMesh&);

}  // namespace weft::scene
