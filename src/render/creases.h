// Normals of a mesh that is smooth here and sharp there.
#pragma once

#include "render/solids.h"

#include <vector>

namespace weft::render {

/// Triangles of three `indices` each. A vertex has one normal for those around it that lie within
/// 40 degrees of each other.
Triangles with_creases(const std::vector<Vector3d>& places, const std::vector<uint32_t>& indices);

}  // namespace weft::render
