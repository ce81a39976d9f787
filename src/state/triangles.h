// Triangles around the particles of meshes, in sliced rows like the springs (state/springs.h).
//
// Entry (k, lane) names the other two corners of the lane's k-th triangle, in its sense of
// rotation, ascending by triangle. Short rows are filled with the particle itself, which spans no
// area.
#pragma once

#include "state/counts.h"

namespace weft {

struct TriangleRows {
  const int64_t* start;        ///< per slice and one more: first entry
  const int32_t *next, *last;  ///< elements: the triangle is (particle, next, last)
  int first_block;             ///< block of slice 0

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    array(start, n.fan_slices > 0 ? n.fan_slices + 1 : 0);
    array(next, n.corners);
    array(last, n.corners);
    array.number(first_block, n.first_mesh_block);
  }
};

}  // namespace weft
