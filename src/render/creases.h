// Normals of a mesh that is smooth here and sharp there.
#pragma once

#include "render/solids.h"

#include <vector>

namespace weft::render {

struct Creased {
  Triangles triangles;
  std::vector<uint32_t> origins;  ///< by vertex of theirs: the number of the place it is at
};

/// Triangles of three `indices` each. A vertex has one normal for those around it that lie within
/// 40 degrees of each other.
Creased with_creases(const std::vector<Vector3d>& places, const std::vector<uint32_t>& indices);

}  // namespace weft::render
