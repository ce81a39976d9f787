// What a frame asks of a back end: substeps of equal length on one simulation.
#pragma once

#include "state/simulation.h"
#include "step/workers.h"

namespace weft {

template <class T>
struct Frame {
  Simulation<T> sim;
  int substeps;
  bool position_form;
  double dt;         ///< s, of every substep of this frame
  double dt_before;  ///< s, of the last substep before this frame
  bool newcomers;    ///< some cloth has not moved yet: its start belongs to `dt`
  Vec3<T> gravity;
  Wind<T> wind;
  int begin;       ///< substep to go on with: 0, but where a list of pairs needed more room
  int list_age;    ///< substeps since the list of near pairs was made; -1: there is none
  int list_since;  ///< since particles were last expected to go on in some way; -1: never
  int list_every;  ///< where the host cannot see (Team::sees): substeps that lists are made for; 0:
                   ///< every substep makes one of its own
  int list_for;    ///< there: substeps that the list at hand was made for
  int groups_age;  ///< substeps since groups of particles were looked at; -1: never
  uint64_t contact_substep;  ///< number of the last substep with contact
  bool by_block;             ///< some cloth has a list of colliders for each of its blocks
  Workers workers = 1;
};

}  // namespace weft
