// Making a list of near pairs: the passes of a search through cells, complete or staggered.
#pragma once

#include "kernels/near_pairs.h"
#include "kernels/staggered_pairs.h"
#include "step/stage_clock.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Lists the pairs near each other at `x`; `lasting`: for some substeps from p.x_in on.
template <bool Position, class T, class Team>
void list_complete(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
                   Vec3Array<T> x, bool lasting, int since, int given) {
  const Contacts<T>& c = sim.contacts;
  team.for_each_block(sim.blocks, ContactBounds<T, Position>{sim, p, x, lasting, since, given});
  team.meet();
  team.for_each_block(1, PlanCells<T>{c, sim.blocks, lasting, given});
  if (lasting) team.for_each_block(contact_zones / block_size, ClearZones<T>{c});
  team.meet();
  team.for_each_block(sim.blocks, CellKeys<T>{sim, x});
  team.meet();
  team.sort_few_bits(c.key, c.element, sim.blocks * block_size, c.key_bits + 1,
                     {c.room, c.room_words});
  team.meet();
  team.for_each_block(sim.blocks, SortedCells<T>{sim, x});
  team.meet();
  using Finder = CompleteFinder<T>;
  team.for_each_block(sim.blocks, WriteRows<T, Finder>{sim, Finder{x}});
  team.meet();
}

template <class T, class Team>
void list_staggered(const Team& team, const Simulation<T>& sim, Vec3Array<T> x) {
  const Contacts<T>& c = sim.contacts;
  team.for_each_block(1, PlanCells<T>{c, 0, false, 0});
  team.for_each_block(sim.blocks, StaggeredKeys<T>{sim, x});
  team.meet();
  for (int g = 0; g < c.grids; ++g) {
    const int64_t first = int64_t(g) * c.entries_a_grid;
    team.sort_by_key(c.key + first, c.element + first, sim.blocks * block_size, g,
                     {c.room, c.room_words});
  }
  team.meet();
  team.for_each_block(sim.blocks, StaggeredPlaces<T>{c});
  team.meet();
  using Finder = StaggeredFinder<T>;
  team.for_each_block(sim.blocks, WriteRows<T, Finder>{sim, Finder{x, sim.blocks * block_size}});
  team.meet();
}

template <class T, class Team>
void list_pairs(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
                Vec3Array<T> x, bool position_form, bool lasting, int since = 0, int given = 0) {
  if (sim.contacts.search == Search::staggered) {
    list_staggered(team, sim, x);
  } else if (position_form) {
    list_complete<true>(team, sim, p, x, lasting, since, given);
  } else {
    list_complete<false>(team, sim, p, x, lasting, since, given);
  }
  team.lap(Lap::contacts);
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
