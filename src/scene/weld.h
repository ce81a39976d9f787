// Vertices of a render mesh that are one particle: seams of texture coordinates and of normals.
#pragma once

#include "base/host_memory.h"
#include "scene/fabric.h"

namespace weft::scene {

struct Welded {
  Vector<uint32_t> particle_of;  ///< by vertex
  Vector<double3> positions;     ///< by particle: its first vertex's
  Vector<uint32_t> indices;      ///< of the triangles that still have three corners
  Vector<uint32_t> given;        ///< their numbers in the mesh
  Vector<Spring> springs;        ///< that still have two ends
  Vector<double> masses;         ///< by particle: its first vertex's; empty as in the mesh
  uint32_t dropped = 0;          ///< triangles
  uint32_t dropped_springs = 0;
  MeshDesc mesh;  ///< the same over particles; views of the above
};

/// Every vertex joins the first particle nearer than `weld_distance`, in the order of vertices.
Welded weld(const MeshDesc&);

}  // namespace weft::scene
