// The state of a simulation as a surface.
#pragma once

#include "io/build.h"

namespace weft::tools {

/// Positions and, where the surface has room for them, normals.
inline void read_surface(io::Simulation& made, const std::string& where, io::Surface& surface) {
  for (size_t i = 0; i < made.cloths.size(); ++i) {
    const size_t first = surface.parts[i].first_vertex;
    const ClothId cloth = made.cloths[i];
    made.require(made.world.read_positions(cloth, &surface.positions[first]), where);
    if (surface.normals.empty()) continue;
    made.require(made.world.read_normals(cloth, &surface.normals[first]), where);
  }
}

}  // namespace weft::tools
