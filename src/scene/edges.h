// The springs of a fabric once each, and the springs of each vertex: what scatter works on
// (state/edges.h).
#pragma once

#include "base/memory_host.h"
#include "scene/fabric.h"

namespace weft::scene {

struct Edge {
  uint32_t a, b;   ///< storage indices, a < b
  uint64_t entry;  ///< grids: stencil neighbour of a; others: entry of fabric.rows
};

struct Edges {
  Vector<Edge> edges;  ///< ascending (a, order in its row)
  // Sliced rows: e where the vertex is end a of edge e, ~e where it is end b, and padding(*this).
  Vector<int64_t> slice_start;
  Vector<int32_t> incident;
};

/// A spring without force: the filling of short rows, behind the last of the edges.
inline int32_t padding(const Edges& e) { return static_cast<int32_t>(e.edges.size()); }
/// Room for the edges and at least one of padding, in whole blocks.
uint64_t padded_edges(uint64_t edges);
/// Entries of the sliced rows, without making them.
int64_t incident_entries(const CookedFabric&);
Edges build_edges(const CookedFabric&);

}  // namespace weft::scene
