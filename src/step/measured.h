// The formats of forces that exist to be measured, where a substep passes through them. All that is
// particular to them is behind this file, in kernels/measured.
#pragma once

#include "kernels/hubs.h"
#include "kernels/measured/spring_forces.h"
#include "kernels/measured/sum_forces.h"
#include "step/stage_clock.h"

namespace weft {
namespace WEFT_BACKEND_NS {
namespace measured {

/// Springs of the cloths that scatter, and their sums.
template <class T, class Team>
void springs_before(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
                    const StepParams<T>& step) {
  const Edges<T>& edges = sim.edges;
  if (edges.accumulation == Accumulation::fixed8) {
    team.for_each_block(1, ForgetLargest<T>{edges.largest});
    team.meet();
  }
  team.for_each_block(edges.blocks, SpringForces<T>{{sim, p, step}});
  team.meet();
  team.lap(Lap::springs);
  if (sim.hubs.chunks > 0) {
    team.for_each_block(sim.hubs.chunks, HubChunks<T>{sim, p, step});  // of cloths that gather
    team.meet();
    team.for_each_block(sim.hubs.chunks, SumChunks<T>{sim});
    team.meet();
    team.lap(Lap::hubs);
  }
  team.for_each_block(edges.particle_blocks, SumForces<T>{sim});
  team.meet();
  team.lap(Lap::sums);
}

/// After the particles of a substep.
template <class T, class Team>
void round_after(const Team& team, const Edges<T>& edges, const ParticleBuffers<T>& p,
                 Update update) {
  if (update != Update::summed && update != Update::position) return;
  if (edges.blocks == 0 || edges.accumulation != Accumulation::float24_all) return;
  team.for_each_block(edges.particle_blocks, RoundState<T>{edges, p});
  team.meet();
}

}  // namespace measured
}  // namespace WEFT_BACKEND_NS
}  // namespace weft
