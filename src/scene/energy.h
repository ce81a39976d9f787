// Energies and momentum of a cloth, in double on the host.
#pragma once

#include "scene/fabric.h"

namespace weft::scene {

/// Of a cloth at world positions `x` with velocities `v`; `rest(i, j)` is the rest length of a
/// spring whose length is initial. Pinned vertices count neither kinetic nor potential energy nor
/// momentum.
struct EnergyInput {
  const CookedFabric& fabric;
  View<double3> x;
  View<double3> v;
  const Array<uint8_t>* pinned;  ///< null: none
  double3 gravity;
  View<double3> rest_shape;  ///< posed as at the start; only differences count
};
struct Energies {
  double kinetic = 0, elastic = 0, potential = 0;
  double3 momentum{0, 0, 0};
  /// The largest (l - l0)/l0 of a spring that is no bend spring, with l0 above a billionth of the
  /// longest: of a mesh, of the edges of its triangles. What folds changes the length of a bend
  /// spring and stretches nothing.
  double stretch = 0;
};
Energies energies(const EnergyInput&);

}  // namespace weft::scene
