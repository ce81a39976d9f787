// Vertices of a render mesh that are one particle: seams of texture coordinates and of normals.
#pragma once

#include "base/host_memory.h"
#include "scene/fabric.h"

namespace weft::scene {

struct Welded {
  Vector<uint32_t> particle_of;  ///< by vertex
  Vector<double3> positions;     ///< by particle: its first vertex's
  Vector<uint32_t> indices;      ///< of the triangles that still have three corners
  Vector<double> masses;         ///< by particle: its first vertex's; empty as in the mesh
  uint32_t dropped = 0;               ///< triangles
  MeshDesc mesh;                      ///< the same over particles; views of the above
};

/// Every vertex joins the first particle within `weld_distance` of it, in the order of vertices.
Welded weld(const MeshDesc&);

}  // namespace weft::scene
