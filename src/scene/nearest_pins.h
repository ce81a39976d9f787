// Which pin is nearest to a vertex along the surface, and how far.
#pragma once

#include "scene/fabric.h"

namespace weft::scene {

constexpr uint32_t no_pin = ~0u;

struct NearestPins {
  explicit NearestPins(std::pmr::memory_resource* memory) : pin(memory), distance(memory) {}
  Array<uint32_t> pin;     ///< by vertex: a vertex; no_pin where none is reached
  Array<double> distance;  ///< m: of the shortest path over edges, in rest lengths
};

/// Edges are the sides of triangles; of grids the stretch and shear springs, of networks all
/// springs. Of two pins equally near the one of lower index counts. `pins`: vertices.
NearestPins nearest_pins(const CookedFabric&, const Array<uint32_t>& pins,
                         std::pmr::memory_resource* memory);

}  // namespace weft::scene
