// The largest step that explicit Verlet may take.
#pragma once

#include <functional>

#include "scene/fabric.h"

namespace weft::scene {

/// dt^2 K + 2 dt C = 4, K and C the largest S_i/m_i + S_j/m_j over the springs with S_i the summed
/// stiffness (damping) of vertex i, pinned vertices counting 1/m = 0 (scaled Gershgorin bound on
/// the edge matrix: rigorous at every deformation for the positive part of the stiffness,
/// linearly). Wind counts as a lagged drag that its own limit keeps below G/(1 + G), G = C dt/m: it
/// can bring the bound down by a factor of sqrt(2) at most, of 2 where damping sets it. That is to
/// the safe side: what the step makes of wind is implicit enough to need no bound for itself.
struct Bound {
  double dt;  ///< infinite when nothing bounds it
  uint32_t a,
      b;  ///< what bounds it most: a spring, by stiffness or damping; a == b: a vertex's drag
};

struct BoundInput {
  const Array<uint8_t>* pinned;  ///< per vertex; null: none
  double lagged_drag;            ///< N s/m; 0 for central drag, which lowers nothing
  double spring_damping;         ///< N s/m
  double wind = 0;      ///< N s/m per m^2 of 2 A: the most that a corner of a triangle feels
  bool springs = true;  ///< they are forces: their stiffness bounds the step
};

Bound stable_bound(const CookedFabric&, const BoundInput&);

}  // namespace weft::scene
