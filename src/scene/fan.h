// Triangles around the vertices of a mesh, as sliced rows in storage order (state/triangles.h).
#pragma once

#include "base/memory_host.h"
#include "scene/fabric.h"

namespace weft::scene {

struct Fans {
  Vector<int64_t> slice_start;  ///< per slice of 32 and one more: first entry
  /// Storage indices of the other two corners, in the triangle's sense; padded by the vertex
  /// itself.
  Vector<int32_t> next, last;
};
Fans build_fans(const CookedFabric&);
/// Entries that build_fans would make, without making them; 0 without triangles.
int64_t fan_entries(const CookedFabric&);

}  // namespace weft::scene
