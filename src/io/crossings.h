// Where a surface passes through itself.
#pragma once

#include "weft/core.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace weft::io {

/// Pairs (i, j), i < j, of triangles that share no vertex and whose interiors cross: each has
/// vertices on both sides of the other, and more than a point of one's inside lies in the other's.
/// Exact (io/orientation.h): triangles that touch, lie in one plane or are a line do not cross; nor
/// does one with a vertex that is not finite. In ascending order; indices must be valid.
std::vector<std::array<uint32_t, 2>> crossings(
    const std::vector<double3>& positions, const std::vector<std::array<uint32_t, 3>>& triangles);

}  // namespace weft::io
