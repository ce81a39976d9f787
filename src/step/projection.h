// The order of a substep whose springs are constraints (XPBD): prediction, springs, displacement.
#pragma once

#include "kernels/project_springs.h"
#include "step/exec_contract.h"
#include "step/fans.h"
#include "step/variants.h"
#include "step/workers.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Blocks of a colour that are worth waiting for each other.
constexpr int worth_meeting = 128;

/// Blocks that threads are chosen by: all, but where springs are constraints and nothing else is
/// much work, no more than there are cloths to take.
template <class T>
int blocks_to_share(const Simulation<T>& sim) {
  const ColourTable& table = sim.coloured.table;
  const bool more = sim.windy || sim.contacts.state != nullptr || sim.reach != nullptr;
  if (table.colours == 0 || more) return sim.blocks;
  const int64_t all = table.work[table.cloths];
  if (all >= int64_t(worth_meeting) * table.colours) return sim.blocks;
  const int threads = static_cast<int>(all / table.most_of_a_cloth);
  return sim.blocks < blocks_a_thread * threads ? sim.blocks : blocks_a_thread * threads;
}

/// Where particles would be without springs. Pins are placed: springs pull to where they are at the
/// end of the substep.
template <StageSet Set, class T, class Team>
void predict(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
             const StepParams<T>& step) {
  for (int r = 0; r < sim.range_count; ++r) {
    const BlockRange range = sim.ranges[r];
    with_fan(range.kind, sim, [&](auto fan) {
      using Springs = Unsprung<decltype(fan)>;
      team.for_each_block(range.count, AdvanceParticles<T, Springs, Set>{
                                           {sim, p, step}, Springs{}, fan, range.first});
    });
  }
}

/// Whether threads take cloths, and not the springs of a colour: where no cloth keeps the others
/// waiting, or the colours are too small to share.
inline bool by_cloth(const ColourTable& table, int threads) {
  const int64_t all = table.work[table.cloths];
  if (threads == 1 || int64_t(table.most_of_a_cloth) * threads <= all + all / 4) return true;
  return all < int64_t(worth_meeting) * table.colours;
}

/// From the forces to the springs, one colour after the other.
template <class T, class Team>
void predict_and_project(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
                         const StepParams<T>& step) {
  if constexpr (Team::fuses) {
    predict<before_springs>(team, sim, p, step);
  } else if (sim.windy) {
    predict<before_springs>(team, sim, p, step);
  } else {
    predict<before_springs_in_still_air>(team, sim, p, step);
  }
  team.meet();
  team.lap(Lap::advance);
  const ColourTable& table = sim.coloured.table;
  if constexpr (Team::sees) {
    if (by_cloth(table, team.threads())) {
      team.for_each_block(table.cloths, ProjectCloths<T>{{sim, p, step.dt, step.square, 0}, table});
      team.meet();
      team.lap(Lap::springs);
      return;
    }
  }
  for (int colour = 0; colour < table.colours; ++colour) {
    const int first = table.start[colour], end = table.start[colour + 1];
    team.for_each_block(end - first, ProjectSprings<T>{sim, p, step.dt, step.square, first});
    team.meet();
  }
  team.lap(Lap::springs);
}

/// What the springs have done becomes displacement; then the stages of `Set`.
template <StageSet Set, class T, class Team>
void follow_projection(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
                       const StepParams<T>& step) {
  team.for_each_block(sim.blocks, AdvanceParticles<T, Projected, Set>{{sim, p, step}, {}, {}, 0});
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
