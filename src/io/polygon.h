// Polygons to triangles, shared by the readers.
#pragma once

#include "io/memory_limit.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace weft::io {

/// Appends the fan (p0, p1, p2), (p0, p2, p3), ... of a polygon of at least three vertices. False
/// when there is no memory for it.
inline bool append_fan(const std::vector<uint32_t>& polygon, std::vector<uint32_t>& triangles,
                       MemoryLimit& memory) {
  if (!memory.make_room(triangles, 3 * (polygon.size() - 2))) return false;
  for (size_t k = 2; k < polygon.size(); ++k) {
    triangles.insert(triangles.end(), {polygon[0], polygon[k - 1], polygon[k]});
  }
  return true;
}

/// A vertex that a polygon of more than three vertices names twice; null when there is none.
/// Fanned, such a polygon would give overlapping or degenerate triangles. (Triangles are the
/// library's to judge.)
inline const uint32_t* repeated_vertex(std::vector<uint32_t>& scratch) {
  if (scratch.size() <= 3) return nullptr;
  std::sort(scratch.begin(), scratch.end());
  const auto twice = std::adjacent_find(scratch.begin(), scratch.end());
  return twice == scratch.end() ? nullptr : &*twice;
}

}  // namespace weft::io
