// The smallest networks: a mass on a spring at an anchor, free particles, chains.
#pragma once

#include "reference/world_helpers.h"

namespace weft_tests {

/// Vertex 0 is the anchor at the origin (pinned), vertex 1 a mass at `start`.
class AnchoredMass {
 public:
  double stiffness = 100, mass = 1, rest_length = 1;
  Vec start{1.25, 0, 0}, velocity;
  double drag = 0, spring_damping = 0;
  weft::DragModel drag_model = weft::DragModel::central;
  std::vector<weft::PinMotion> motions;  // one at most: of the anchor

  weft::ClothId add_to(TestWorld& test) const {
    const std::vector<weft::double3> positions{{0, 0, 0}, to_weft(start)};
    const std::vector<weft::double3> velocities{{0, 0, 0}, to_weft(velocity)};
    const std::vector<weft::Spring> springs{{0, 1, stiffness, rest_length}};
    const std::vector<double> masses{mass, mass};
    weft::NetworkDesc network;
    network.positions = weft::View<weft::double3>(positions);
    network.springs = springs;
    network.material.mass.kind = weft::Mass::Kind::per_vertex;
    network.material.mass.values = masses;
    const std::vector<weft::Pin> pins{{0, motions.empty() ? weft::Pin::fixed : 0}};
    weft::ClothDesc cloth;
    cloth.velocities = velocities;
    cloth.pins = pins;
    cloth.motions = motions;
    cloth.drag = drag;
    cloth.drag_model = drag_model;
    cloth.spring_damping = spring_damping;
    return test.add(network, cloth);
  }
};

/// A network of free particles, `mass` kg each.
inline weft::ClothId add_particles(TestWorld& test, const std::vector<Vec>& at, Vec velocity = {},
                                   double mass = 1, double drag = 0,
                                   weft::DragModel model = weft::DragModel::central) {
  const std::vector<weft::double3> positions = to_weft(at);
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(positions);
  network.material.mass.value = mass * double(at.size());
  weft::ClothDesc cloth;
  cloth.velocity = to_weft(velocity);
  cloth.drag = drag;
  cloth.drag_model = model;
  return test.add(network, cloth);
}

/// A network with springs given one by one and equal masses.
struct NetworkParts {
  std::vector<Vec> positions;
  std::vector<weft::Spring> springs;
  std::vector<double> masses;  // one for all, or one each
  std::vector<uint32_t> pins;
  std::vector<Vec> start;  // empty: the positions
  std::vector<Vec> velocities;
};

inline weft::ClothId add_network(TestWorld& test, const NetworkParts& parts,
                                 weft::ClothDesc cloth = {}) {
  const std::vector<weft::double3> rest = to_weft(parts.positions);
  const std::vector<weft::double3> start = to_weft(parts.start);
  const std::vector<weft::double3> velocities = to_weft(parts.velocities);
  std::vector<double> masses = parts.masses;
  if (masses.size() == 1) masses.assign(rest.size(), masses[0]);
  std::vector<weft::Pin> pins;
  for (uint32_t p : parts.pins) pins.push_back({p, weft::Pin::fixed});
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(rest);
  network.springs = parts.springs;
  network.material.mass.kind = weft::Mass::Kind::per_vertex;
  network.material.mass.values = masses;
  if (!start.empty()) cloth.positions = weft::View<weft::double3>(start);
  cloth.velocities = velocities;
  if (!pins.empty()) cloth.pins = pins;
  return test.add(network, cloth);
}

}  // namespace weft_tests
