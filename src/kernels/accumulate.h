// How the forces of springs that are evaluated once each add up on a vertex: in ascending neighbour
// index, whatever the order of storage.
#pragma once

#include "base/lanes.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Force of a spring on the particle whose row names it (state/edges.h).
template <class T>
WEFT_HD Vec3<T> incident_force(Vec3Array<T> forces, int32_t incident) {
  const bool second = incident < 0;
  const Vec3<T> f = load(forces, second ? ~incident : incident);
  return select(second, Vec3<T>{-f.x, -f.y, -f.z}, f);
}

/// Springs of the particles of `count` blocks from the first on, and as much again for each.
template <class T>
WEFT_HD int64_t incident_before(const Edges<T>& edges, int first_block, int count) {
  const int slice = first_block - edges.first_block;
  return edges.start[slice + count] - edges.start[slice] + int64_t(count) * block_size;
}

/// Adds the forces of the springs of each particle of a block; hubs: kernels/hubs.h.
template <class T, int N>
WEFT_HD void sum_incident(const Edges<T>& edges, Vec3Array<T> forces, int block, int i0,
                          Lanes<N> lanes, LaneVec3<T, N>& total) {
  const int slice = block - edges.first_block;
  for (int64_t e = edges.start[slice] + (i0 - block * block_size); e < edges.start[slice + 1];
       e += block_size) {
    lanes.each([&](int l) WEFT_LANE {
      total.set(l, total.get(l) + incident_force(forces, edges.incident[e + l]));
    });
  }
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
