// Grid sheets as weft cloth and as reference system, from one description.
#pragma once

#include "reference/grid.h"
#include "reference/random.h"
#include "reference/verlet.h"
#include "reference/world_helpers.h"

namespace weft_tests {

inline reference::Offsets offsets(weft::Stencil stencil) {
  switch (stencil) {
    case weft::Stencil::seed12:
      return reference::seed12();
    case weft::Stencil::classic12:
      return reference::classic12();
    case weft::Stencil::quad4:
      return reference::quad4();
    case weft::Stencil::tri6:
      break;
  }
  return reference::tri6();
}

/// A rows x columns sheet in the unit square with equal vertex masses.
struct Sheet {
  uint32_t rows = 8, columns = 8;
  weft::Stencil stencil = weft::Stencil::seed12;
  double stiffness = 1000, vertex_mass = 0.01;
  std::vector<uint32_t> pins;
  double noise = 0;  ///< half width, of splitmix64 with `seed`
  uint64_t seed = 1;
  bool single = false;  ///< positions are rounded to float first

  uint32_t count() const { return rows * columns; }

  std::vector<Vec> start() const {
    std::vector<Vec> x = reference::grid_positions(rows, columns);
    reference::SplitMix random(seed);
    for (Vec& p : x) {
      if (noise > 0) p += random.noise(noise);
      if (single) p = reference::through_float(p);
    }
    return x;
  }

  reference::System system() const {
    reference::System system;
    system.positions = start();
    system.masses.assign(count(), vertex_mass);
    system.pins = pins;
    system.springs = reference::grid_springs_at_rest(rows, columns, offsets(stencil), stiffness,
                                                     reference::grid_positions(rows, columns));
    return system;
  }

  weft::GridDesc grid() const {
    weft::GridDesc desc;
    desc.rows = rows;
    desc.columns = columns;
    desc.stencil = stencil;
    desc.material.stiffness = stiffness;
    desc.material.mass.value = vertex_mass * count();
    return desc;
  }

  weft::ClothId add_to(TestWorld& test, weft::ClothDesc cloth = {}) const {
    const std::vector<weft::double3> x = to_weft(start());
    std::vector<weft::Pin> pinned;
    for (uint32_t p : pins) pinned.push_back({p, weft::Pin::fixed});
    cloth.positions = weft::View<weft::double3>(x);
    cloth.pins = pinned;
    return test.add(grid(), cloth);
  }

  /// The same springs as a network, each with its rest length from double precision.
  weft::ClothId add_network_to(TestWorld& test, weft::ClothDesc cloth = {}) const {
    const std::vector<weft::double3> rest = to_weft(reference::grid_positions(rows, columns));
    const std::vector<weft::double3> x = to_weft(start());
    std::vector<weft::Spring> springs;
    for (const reference::Spring& s : system().springs) springs.push_back({s.a, s.b, -1, s.rest});
    std::vector<weft::Pin> pinned;
    for (uint32_t p : pins) pinned.push_back({p, weft::Pin::fixed});
    weft::NetworkDesc network;
    network.positions = weft::View<weft::double3>(rest);
    network.springs = springs;
    network.material.stiffness = stiffness;
    network.material.mass.value = vertex_mass * count();
    cloth.positions = weft::View<weft::double3>(x);
    cloth.pins = pinned;
    return test.add(network, cloth);
  }
};

}  // namespace weft_tests
