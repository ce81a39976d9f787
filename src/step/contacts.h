// The order of self-collision within a substep.
//
//   substep with groups:     advance, colliders too (has anyone strayed?)             most often
//                            advance, all colliders wait | how groups move |
//                            (boxes of groups, of blocks, of 32 blocks | pairs of groups)?  rarely
//                            rows of the pairs of groups that have nothing left | where any touch
//                            count | (push | apply) 4 times | colliders, in every block
//   substep with a list:     advance (who is not where the list expects it?)
//                            count | (push | apply) 4 times | colliders, in the blocks of the list
//   making a list:           bounds, cells | keys | sort | cells' ranges | rows
//   substep without:         advance, all colliders wait | list of the new positions |
//                            count | (push | apply) 4 times | colliders, in every block
//
// Groups of particles (kernels/near_groups.h) do where they are compact; of particles that lie
// about, too many of them are near each other, and cells find who is.
//
// A list is made of the positions at the start of a substep and holds for as long as every particle
// goes on as expected. When one has not, a list is made of the same start and the substep repeated;
// if even that one fails, as in an explosion, the substep is made without. A step's bits do not
// depend on which of these ways it has gone.
//
// A GPU's host enqueues a frame without looking at it: lists are made every so many substeps, as
// the arena has chosen before, and a frame that has outrun one is made again with a list in every
// substep.
#pragma once

#include "kernels/collide_pass.h"
#include "kernels/near_groups.h"
#include "kernels/push_apart.h"
#include "step/near_lists.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <bool Position, class T, class Team>
void push_apart(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
                const StepParams<T>& step, bool exact) {
  const T weight = step.dt * step.dt * square_root(dot(step.gravity, step.gravity));
  team.for_each_block(sim.blocks, CountTouching<T>{sim, p.x_out, exact});
  for (int pass = 0; pass < contact_passes; ++pass) {
    const bool again = pass > 0;
    team.meet();
    team.for_each_block(sim.blocks, PushApart<T, Position>{sim, p, step.dt, weight, again, exact});
    team.meet();
    team.for_each_block(sim.blocks, ApplyPushes<T, Position>{sim, p, again});
  }
  team.lap(Lap::contacts);
}

/// What the rows of a list hold: nothing, pairs that are near, or those that touch and no others.
enum class Rows { empty, near, touching };

/// From the forces to the pins, but for what waits for contact.
template <class T, class Team>
void advance_before_contact(const Team&, const Simulation<T>&, const ParticleBuffers<T>&,
                            const StepParams<T>&);

/// Contact, and what has waited for it. `keeps`: in the position form the previous positions are
/// changed, so that no overlap becomes speed.
template <class T, class Team>
void respond_to_contact(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
                        const StepParams<T>& step, bool keeps = true, Rows rows = Rows::near) {
  const bool any = rows != Rows::empty, exact = rows == Rows::touching;
  if (any && step.position_form) push_apart<true>(team, sim, p, step, exact);
  if (any && !step.position_form) push_apart<false>(team, sim, p, step, exact);
  if (sim.reach != nullptr) {
    Simulation<T> later = sim;
    later.places_pins = false;  // they are where they belong
    if constexpr (Team::fuses) {
      team.for_each_block(sim.blocks, CollidePass<T, Meets::all>{{later, p, step}});
    } else {
      team.meet();
      team.for_each_block(sim.blocks, CollidePass<T, Meets::shapes>{{later, p, step}});
      if (sim.near_memory != nullptr) {
        team.meet();
        team.for_each_block(sim.blocks, CollidePass<T, Meets::meshes>{{later, p, step}});
      }
    }
  }
  if (any && step.position_form && keeps) {
    team.for_each_block(sim.blocks, KeepDisplacement<T>{sim, p});
  }
  team.meet();
  team.lap(Lap::advance);
}

/// How old the list is, as every thread of a team counts for itself.
struct ListAge {
  int substeps = -1;     ///< -1: there is none
  int since = -1;        ///< since Contacts::from was written; -1: never
  int made_for = 0;      ///< where the host cannot see: substeps
  int groups = -1;       ///< since groups were looked at; -1: they are not known
  uint64_t substep = 0;  ///< number of the last one
};

/// Whether the list has room for all that it was made to hold.
template <class T>
bool fits(const Contacts<T>& c) {
  return c.state->used <= static_cast<unsigned long long>(c.capacity);
}

/// Where groups are too crowded, a list is not worth its time that is outrun in so few substeps, or
/// that has so many entries for each particle: of particles that fly about.
constexpr int least_worth = 3, most_entries = 12;
template <class T>
bool is_too_wide(const Simulation<T>& sim) {
  const auto most = static_cast<unsigned long long>(sim.blocks) * block_size * most_entries;
  return sim.contacts.by_groups != 0 && sim.contacts.state->used > most;
}

/// Tries a substep with a list. False: a particle has outrun it, or there was no room for it.
template <class T, class Team>
bool substep_with_list(const Team& team, Simulation<T>& sim, const ParticleBuffers<T>& p,
                       const StepParams<T>& step, ListAge& age) {
  Contacts<T>& c = sim.contacts;
  for (;;) {
    const bool makes = age.substeps < 0 || age.substeps >= c.state->horizon;
    if (makes) {
      list_pairs(team, sim, p, p.x_in, step.position_form, true, age.since);
      age.substeps = age.since = 0;
      if (c.state->horizon == 0 || !fits(c) || is_too_wide(sim)) return false;
    }
    ++age.substeps;
    c.age = T(age.substeps);
    c.waits = Team::fuses ? Waits::listed : Waits::every;
    advance_before_contact(team, sim, p, step);
    const bool outrun = c.state->outrun != 0;
    if (!outrun) break;
    team.meet();  // all have seen it
    if (team.leads()) {
      c.state->outrun = 0;
      c.state->limit = age.substeps > 1 ? age.substeps - 1 : 1;
    }
    team.meet();
    if (age.substeps <= (c.by_groups != 0 ? least_worth : 1)) return false;
    age.substeps = -1;
  }
  respond_to_contact(team, sim, p, step);
  ++age.since;
  if (age.substeps == c.state->horizon) {
    if (team.leads()) {
      const int limit = c.state->limit + 1 + c.state->limit / 4;
      c.state->limit = limit < 4096 ? limit : 4096;
      c.state->backoff = 1;
    }
    team.meet();
  }
  return true;
}

/// How many substeps are tried without a look, after the last try took `done` of them.
constexpr int most_ahead = 64;
/// Where nothing touches, pairs of groups are looked into that would have less left, in distances.
constexpr double early_look = 0.05;
inline int next_ahead(int ahead, int done) {
  if (done >= ahead) return ahead < most_ahead / 2 ? 2 * ahead : most_ahead;
  return done > 1 ? done : ahead > 2 ? ahead / 2 : 1;
}

/// A try that fails at once costs a substep: the next one waits for twice as many looks.
constexpr int most_hold = 32;
inline void note_try(ContactState& state, bool failed, int done) {
  if (failed) {
    state.holds = done > 0 ? 0 : state.holds > 0 ? smaller(2 * state.holds, most_hold) : 1;
    state.hold = state.holds;
  } else if (state.hold > 0) {
    --state.hold;
  }
}

/// So far may particles go meanwhile from where their groups would be.
inline double budget_of(const ContactState& state) {
  return 0.9999 * smaller(0.5 * unordered(state.least_left), unordered(state.least_ahead));
}

/// How far, in distances, the fastest may go while pairs of groups last; and limits of how long.
constexpr double pairs_last = 4, least_horizon = 24, most_horizon = 512;

/// Looks into pairs of groups, of each group, and the substeps that cells are used for after more.
constexpr unsigned most_looks = 32, crowd_lasts = 128;
/// Substeps without a list after groups were found crowded: such particles fly about.
constexpr int first_wait = 16;

enum class Outcome { done, full, crowded };

/// Pairs of groups, of the positions p.x_out. False: there are too many even if they last for few
/// substeps.
template <class T, class Team>
bool pair_groups(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
                 int since) {
  const Contacts<T>& c = sim.contacts;
  const double pace = unordered(c.state->most_pace);
  const double far = pairs_last * c.most_distance;
  double part = c.state->part;
  for (; part > 0.1; part *= 0.5) {
    const double lasts = pace * most_horizon > far ? far / pace : most_horizon;
    const int horizon =
        static_cast<int>(part * (since > 0 ? larger(least_horizon, lasts) : least_horizon));
    if (team.leads()) {
      c.state->least_beyond = c.state->least_ahead = ordered(endless);
    }
    team.meet();
    team.for_each_block(sim.blocks, BoxGroups<T>{sim, p, since, horizon, part});
    team.meet();
    team.for_each_block((sim.blocks + 31) / 32, BoxBlocks<T>{c, sim.blocks, horizon});
    team.meet();
    team.for_each_block(sim.blocks, PairGroups<T>{sim, horizon, since > 0});
    team.meet();
    if (c.state->crowded == 0) break;
    since = 0;  // the motions are used up
  }
  if (team.leads()) c.state->part = part > 0.1 ? smaller(1.1 * part, 1.0) : 1.0;
  return part > 0.1;
}

/// Pairs of groups that last no substep are not worth their time.
inline void note_restless(ContactState& state, uint64_t substep) {
  state.restless = substep <= state.paired + 1 ? state.restless + 1 : 0;
  if (state.restless < 8) return;
  state.restless = 0;
  state.crowded_until = substep + crowd_lasts;
  state.wait = state.backoff = first_wait;
}

/// A substep whose contacts are looked for among groups, where any may be.
template <class T, class Team>
Outcome substep_with_groups(const Team& team, Simulation<T>& sim, const ParticleBuffers<T>& p,
                            const StepParams<T>& step, ListAge& age) {
  Contacts<T>& c = sim.contacts;
  bool tried = false;
  c.age = T(0);
  c.substep = age.substep;
  if (age.groups >= 0) {
    const int since = age.groups + 1;
    const double budget = c.state->budget;
    const bool lasts = age.substep < c.state->paired + static_cast<uint64_t>(c.state->pair_horizon);
    if (lasts && since <= c.state->ahead && budget > 0.0 && c.state->hold == 0) {
      tried = true;
      c.waits = Waits::none;
      c.still = T(since) / T(c.state->span);
      c.budget = T(budget);
      advance_before_contact(team, sim, p, step);
      c.still = T(0);
      if (c.state->moved[age.substep % 2] != age.substep) {
        age.groups = since;
        return Outcome::done;
      }
      c.substep = ++age.substep;
    }
  }
  c.waits = Waits::every;
  c.still = T(0);
  advance_before_contact(team, sim, p, step);
  const bool known = age.groups >= 0;
  if (team.leads()) {
    c.state->used = c.state->looks = 0;
    c.state->most_pace = ordered(0.0);
    c.state->least_left = c.state->least_beyond = c.state->least_ahead = ordered(endless);
    c.state->ahead = next_ahead(c.state->ahead, known ? age.groups : 0);
    note_try(*c.state, tried, age.groups);
  }
  team.meet();
  const int since = age.groups + 1;
  const int span = known ? since : 1;
  if (team.leads()) c.state->span = span;
  c.onward = T(c.state->ahead) / T(span);
  c.early = c.state->quiet != 0 ? T(early_look * c.most_distance) : T(0);
  bool wanted = !known;
  if (known) {
    team.for_each_block(sim.blocks, MoveGroups<T>{sim, p.x_out, since});
    team.meet();
    wanted = !(unordered(c.state->least_beyond) >= 0.0) ||
             age.substep >= c.state->paired + static_cast<uint64_t>(c.state->pair_horizon);
    team.for_each_block(1, AverageMotion<T>{sim, since});
    if (wanted && team.leads()) note_restless(*c.state, age.substep);
    if (wanted) team.meet();
  } else if (team.leads()) {
    for (double& pace : c.state->pace) pace = 0.0;
  }
  age.groups = -1;
  if (wanted && !pair_groups(team, sim, p, known ? since : 0)) return Outcome::crowded;
  team.for_each_block(sim.blocks, WriteRows<T, GroupFinder<T>>{sim, GroupFinder<T>{p.x_out}});
  team.meet();
  if (!fits(c)) return Outcome::full;
  // Where all are near many others, cells are cheaper.
  const auto many = most_looks * static_cast<unsigned long long>(sim.blocks * groups_a_block);
  if (team.leads() && c.state->looks > many) c.state->crowded_until = age.substep + crowd_lasts;
  age.groups = 0;
  if (team.leads()) {
    c.state->budget = budget_of(*c.state);
    c.state->quiet = c.state->used == 0 ? 1 : 0;
  }
  respond_to_contact(team, sim, p, step, true, c.state->used > 0 ? Rows::touching : Rows::empty);
  return Outcome::done;
}

/// A substep of every cloth with contact. False: nothing has happened, the list needs more room.
template <class T, class Team>
bool substep_with_contact(const Team& team, Simulation<T>& sim, const ParticleBuffers<T>& p,
                          const StepParams<T>& step, ListAge& age) {
  Contacts<T>& c = sim.contacts;
  ++age.substep;
  if (c.by_groups != 0 && c.search == Search::complete && age.substep >= c.state->crowded_until) {
    age.substeps = age.since = -1;
    const Outcome outcome = substep_with_groups(team, sim, p, step, age);
    if (outcome != Outcome::crowded) return outcome == Outcome::done;
    team.meet();
    if (team.leads()) {
      const int backoff = c.state->crowd_backoff;
      c.state->crowded_until = age.substep + 64u * static_cast<uint64_t>(backoff);
      c.state->crowd_backoff = backoff < 32 ? 2 * backoff : 64;
      c.state->wait = c.state->backoff = first_wait;
    }
    team.meet();
  }
  age.groups = -1;
  if (c.search == Search::complete && c.skin > 0.0 && c.state->wait == 0) {
    if (substep_with_list(team, sim, p, step, age)) return true;
    const bool full = !fits(c);
    const bool planned = c.state->wait > 0;
    team.meet();
    age.substeps = -1;
    if (full) return false;
    if (!planned && team.leads()) {
      c.state->wait = c.state->backoff;
      c.state->backoff = 2 * c.state->backoff < 64 ? 2 * c.state->backoff : 64;
    }
  }
  c.age = T(0);
  c.waits = Waits::every;
  advance_before_contact(team, sim, p, step);
  list_pairs(team, sim, p, p.x_out, step.position_form, false);
  if (!fits(c)) return false;
  respond_to_contact(team, sim, p, step);
  if (age.since >= 0) ++age.since;
  if (team.leads() && c.state->wait > 0) --c.state->wait;
  team.meet();
  return true;
}

/// A substep whose lists are planned before: nobody looks at what the kernels find until the frame
/// is over (Team::sees). Where a particle has then outrun a list, or a list had no room, the frame
/// is made again from its start. `every`: Frame::list_every.
template <class T, class Team>
void substep_unseen(const Team& team, Simulation<T>& sim, const ParticleBuffers<T>& p,
                    const StepParams<T>& step, int every, ListAge& age) {
  Contacts<T>& c = sim.contacts;
  if (every > 0) {
    if (age.substeps < 0 || age.substeps >= age.made_for) {
      list_pairs(team, sim, p, p.x_in, step.position_form, true, age.since, every);
      age = {0, 0, every};
    }
    c.age = T(++age.substeps);
    c.waits = Team::fuses ? Waits::listed : Waits::every;
    advance_before_contact(team, sim, p, step);
  } else {
    age.substeps = -1;
    c.age = T(0);
    c.waits = Waits::every;
    advance_before_contact(team, sim, p, step);
    list_pairs(team, sim, p, p.x_out, step.position_form, false);
  }
  respond_to_contact(team, sim, p, step);
  if (age.since >= 0) ++age.since;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
