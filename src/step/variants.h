// The table of compiled kernels: every row once for float and once for double. A test bounds its
// length: effects are stages of these kernels, not rows.
#pragma once

#include "kernels/advance.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Calls `launch` with the springs of a kind of cloth.
template <class T, class Launch>
void with_springs(KernelKind kind, const Simulation<T>& sim, Launch launch) {
  switch (kind) {
    case KernelKind::seed12:
      return launch(GridSprings<T, Seed12>{sim.presence, sim.block.inner});
    case KernelKind::classic12:
      return launch(GridSprings<T, Classic12>{sim.presence, sim.block.inner});
    case KernelKind::quad4:
      return launch(GridSprings<T, Quad4>{sim.presence, sim.block.inner});
    case KernelKind::tri6:
      return launch(GridSprings<T, Tri6>{sim.presence, sim.block.inner});
    case KernelKind::scatter_grid:
      return launch(ScatterSprings<T, GridFan>{sim.edges, sim.hubs});
    case KernelKind::scatter_mesh:
      return launch(ScatterSprings<T, MeshFan>{sim.edges, sim.hubs});
    case KernelKind::mesh_uniform:
      return launch(MeshSprings<T, false>{sim.rows, sim.hubs});
    case KernelKind::mesh_per_spring:
      return launch(MeshSprings<T, true>{sim.rows, sim.hubs});
  }
}

/// What the kernels above are made of where a substep is one pass: on the host.
constexpr StageSet one_pass = every_stage;
/// And on a GPU, whose kernels each have two variants: colliders are passes of their own, and wind,
/// which takes two and a half times the registers, is in a kernel only where it blows.
constexpr StageSet in_still_air = without(without(every_stage, Stage::colliders), Stage::wind);
constexpr StageSet in_wind = without(every_stage, Stage::colliders);

/// Where springs are constraints (XPBD): what comes before them, and behind.
constexpr StageSet before_springs = without(
    without(without(without(every_stage, Stage::spring_damping), Stage::tethers), Stage::contacts),
    Stage::colliders);
constexpr StageSet before_springs_in_still_air = without(before_springs, Stage::wind);
constexpr StageSet behind_springs =
    without(without(without(every_stage, Stage::forces), Stage::spring_damping), Stage::wind);
constexpr StageSet behind_springs_no_colliders = without(behind_springs, Stage::colliders);

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
