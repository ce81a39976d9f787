// One step of the simulation, on one page.
//
//   frame:    reach?, substep, substep, ..., survey       one parallel region, one enqueue
//   reach:    which colliders each block can touch        where a cloth has many near it
//   substep:  springs?, hubs?                    where a cloth scatters or has very many springs
//             advance = forces | wind? | integration | tethers? | colliders? | pins?    one pass;
//             on a GPU shapes? | meshes? | pins? are passes of their own
//             XPBD: forces | wind? | prediction | pins?, then the springs colour by colour, then
//             displacement | tethers? | colliders? | pins?: step/projection.h
//             where particles meet: advance to its seam | contacts | colliders?, step/contacts.h
//             swap:     what was written becomes what is read
//   survey:   where the cloths are, how fast, whether any particle is lost
#pragma once

#include "kernels/collide_pass.h"
#include "kernels/edge_forces.h"
#include "kernels/hubs.h"
#include "kernels/normals.h"
#include "kernels/reach.h"
#include "kernels/shift.h"
#include "kernels/survey.h"
#include "kernels/write_vertices.h"
#include "step/contacts.h"
#include "step/exec_contract.h"
#include "step/fans.h"
#include "step/frame.h"
#include "step/measured.h"
#include "step/projection.h"
#include "step/reduce.h"
#include "step/variants.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Where a substep reads and writes. The position form keeps x_(n-1) in x[2].
template <class T>
ParticleBuffers<T> buffers(const Simulation<T>& sim, bool position_form) {
  if (position_form) return {sim.x[0], sim.x[2], sim.x[1], sim.x[2]};
  return {sim.x[0], sim.d[0], sim.x[1], sim.d[1]};
}

template <class T>
void swap_arrays(Vec3Array<T>& a, Vec3Array<T>& b) {
  const Vec3Array<T> t = a;
  a = b;
  b = t;
}

/// After a substep: next becomes now. The summed form keeps the old x as room for the next; the
/// position form keeps it as x_(n-1) and reuses the one before.
template <class T>
void swap_buffers(Simulation<T>& sim, bool position_form) {
  swap_arrays(sim.x[0], sim.x[1]);
  if (position_form) {
    swap_arrays(sim.x[1], sim.x[2]);
  } else {
    swap_arrays(sim.d[0], sim.d[1]);
  }
}

/// Scalars of substep s of a frame.
template <class T>
StepParams<T> step_params(const Frame<T>& frame, int s) {
  const double before = s == 0 ? frame.dt_before : frame.dt;
  StepParams<T> step{};
  step.update = frame.position_form ? Update::position : Update::summed;
  step.position_form = frame.position_form;
  step.dt = T(frame.dt);
  step.ratio = T(frame.dt / before);
  step.square = T(frame.dt * frame.dt);
  step.a_factor = T(0.5 * frame.dt * (frame.dt + before));
  if (frame.sim.coloured.projects != 0) step.a_factor = step.square;  // y = x + h (v + h a)
  step.newcomers = s == 0 && frame.newcomers;
  step.time = T((s + 1) * frame.dt);
  step.time_before = T(s * frame.dt);
  step.fraction = T(double(s + 1) / frame.substeps);
  step.substep = s;
  step.gravity = frame.gravity;
  step.wind = frame.wind;
  return step;
}

/// The stages of `Set` for every cloth.
template <StageSet Set, class T, class Team>
void advance_ranges(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
                    const StepParams<T>& step) {
  for (int r = 0; r < sim.range_count; ++r) {
    const BlockRange range = sim.ranges[r];
    with_springs(range.kind, sim, [&](auto springs) {
      using Kernel = AdvanceParticles<T, decltype(springs), Set>;
      const auto fan = fan_of(sim, static_cast<const typename Kernel::Fan*>(nullptr));
      team.for_each_block(range.count, Kernel{{sim, p, step}, springs, fan, range.first});
    });
  }
}

/// What the forces of some particles need first: springs that are evaluated once and scattered, and
/// the sums of vertices with very many springs.
template <class T, class Team>
void springs_before(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
                    const StepParams<T>& step) {
  const Edges<T>& edges = sim.edges;
  if (edges.blocks > 0 && is_measured(edges.accumulation)) {  // in a format of step/measured.h
    return measured::springs_before(team, sim, p, step);
  }
  if (edges.blocks > 0) {
    team.for_each_block(edges.blocks, EdgeForces<T>{sim, p, step});
    team.meet();
    team.lap(Lap::springs);
  }
  if (sim.hubs.chunks > 0) {
    team.for_each_block(sim.hubs.chunks, HubChunks<T>{sim, p, step});
    team.meet();
    team.lap(Lap::hubs);
  }
}

/// A substep of every cloth, from its springs to its pins.
template <class T, class Team>
void advance(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
             const StepParams<T>& step) {
  const bool moves = step.update == Update::summed || step.update == Update::position;
  const bool projects = moves && sim.coloured.projects != 0;
  if (projects) {
    predict_and_project(team, sim, p, step);
  } else {
    springs_before(team, sim, p, step);
  }
  if constexpr (Team::fuses) {
    if (projects) {
      follow_projection<behind_springs>(team, sim, p, step);
    } else {
      advance_ranges<one_pass>(team, sim, p, step);
    }
  } else {
    const bool collide = moves && sim.reach != nullptr && sim.activity != nullptr;
    const bool meshes = collide && sim.near_memory != nullptr;
    Simulation<T> first = sim;
    if (collide) first.places_pins = false;  // the last pass places them
    if (projects) {
      follow_projection<behind_springs_no_colliders>(team, first, p, step);
    } else if (sim.windy) {
      advance_ranges<in_wind>(team, first, p, step);
    } else {
      advance_ranges<in_still_air>(team, first, p, step);
    }
    const Simulation<T>& second = meshes ? first : sim;
    if (collide) {
      team.meet();
      team.for_each_block(sim.blocks, CollidePass<T, Meets::shapes>{{second, p, step}});
    }
    if (meshes) {
      team.meet();
      team.for_each_block(sim.blocks, CollidePass<T, Meets::meshes>{{sim, p, step}});
    }
  }
  team.meet();
  measured::round_after(team, sim.edges, p, step.update);
  team.lap(Lap::advance);
}

/// The same up to where particles meet each other; what then follows is in step/contacts.h.
template <class T, class Team>
void advance_before_contact(const Team& team, const Simulation<T>& sim, const ParticleBuffers<T>& p,
                            const StepParams<T>& step) {
  if (sim.coloured.projects != 0) {
    predict_and_project(team, sim, p, step);
    follow_projection<Team::fuses ? behind_springs : behind_springs_no_colliders>(team, sim, p,
                                                                                  step);
    team.meet();
    team.lap(Lap::advance);
    return;
  }
  springs_before(team, sim, p, step);
  if constexpr (Team::fuses) {
    advance_ranges<one_pass>(team, sim, p, step);
  } else if (sim.windy) {
    advance_ranges<in_wind>(team, sim, p, step);
  } else {
    advance_ranges<in_still_air>(team, sim, p, step);
  }
  team.meet();
  measured::round_after(team, sim.edges, p, step.update);
  team.lap(Lap::advance);
}

template <class T, class Team>
void survey(const Team& team, const Simulation<T>& sim, bool position_form) {
  const ParticleBuffers<T> p = buffers(sim, position_form);
  if (position_form) {
    team.for_each_block(sim.survey_count, SurveyParticles<T, true>{sim, p});
  } else {
    team.for_each_block(sim.survey_count, SurveyParticles<T, false>{sim, p});
  }
  team.meet();
}

/// A frame of particles that meet each other, from substep frame.begin on. It ends before its last
/// substep where the list of near pairs needs more room: frame.begin says where. A host that cannot
/// see goes on to the end; ContactState says whether the frame is worth anything.
template <class T, class Exec>
void run_frame_with_contact(Exec& exec, Frame<T>& frame) {
  const int begin = frame.begin;
  exec.frame([&frame, begin](const auto& team) {
    using Team = std::decay_t<decltype(team)>;
    Simulation<T> sim = frame.sim;
    ListAge age{frame.list_age, frame.list_since, frame.list_for, frame.groups_age,
                frame.contact_substep};
    team.start_clock();
    team.meet();  // all have read what the first of them to be done will write
    if constexpr (!Team::sees) {
      team.for_each_block(1, ForgetLists<T>{sim.contacts});
      team.meet();
    }
    if (frame.by_block && begin == 0) {
      team.for_each_block(sim.blocks, ReachOfBlocks<T>{sim, sim.x[0]});
      team.meet();
      team.lap(Lap::reach);
    }
    int s = begin;
    for (; s < frame.substeps; ++s) {
      const ParticleBuffers<T> p = buffers(sim, frame.position_form);
      if constexpr (Team::sees) {
        if (!substep_with_contact(team, sim, p, step_params(frame, s), age)) break;
      } else {
        substep_unseen(team, sim, p, step_params(frame, s), frame.list_every, age);
      }
      swap_buffers(sim, frame.position_form);
    }
    if (s == frame.substeps) {
      survey(team, sim, frame.position_form);
      team.lap(Lap::survey);
    }
    team.meet();
    if (team.leads()) {
      frame.begin = s;
      frame.list_age = age.substeps;
      frame.list_since = age.since;
      frame.list_for = age.made_for;
      frame.groups_age = age.groups;
      frame.contact_substep = age.substep;
    }
  });
  for (int s = 0; s < (frame.begin - begin) % 6; ++s) {
    swap_buffers(frame.sim, frame.position_form);
  }
}

/// Advances a frame. Afterwards frame.sim names the buffers that hold the present.
template <class T, class Exec>
void run_frame(Exec& exec, Frame<T>& frame) {
  if (frame.sim.contacts.state != nullptr) return run_frame_with_contact(exec, frame);
  exec.frame([&frame](const auto& team) {
    Simulation<T> sim = frame.sim;
    team.start_clock();
    if (frame.by_block) {
      team.for_each_block(sim.blocks, ReachOfBlocks<T>{sim, sim.x[0]});
      team.meet();
      team.lap(Lap::reach);
    }
    for (int s = 0; s < frame.substeps; ++s) {
      advance(team, sim, buffers(sim, frame.position_form), step_params(frame, s));
      swap_buffers(sim, frame.position_form);
    }
    survey(team, sim, frame.position_form);
    team.lap(Lap::survey);
  });
  for (int s = 0; s < frame.substeps % 6; ++s) swap_buffers(frame.sim, frame.position_form);
}

/// The displacement (or previous position) before the first substep of the cloths that are
/// starting.
template <class T, class Exec>
void run_start(Exec& exec, Frame<T>& frame) {
  StepParams<T> step = step_params(frame, 0);
  step.update = Update::start;
  ParticleBuffers<T> p = buffers(frame.sim, frame.position_form);
  if (frame.position_form) p.d_out = frame.sim.x[1];
  exec.frame([&](const auto& team) { advance(team, frame.sim, p, step); });
  if (frame.position_form) {
    swap_arrays(frame.sim.x[1], frame.sim.x[2]);
  } else {
    swap_arrays(frame.sim.d[0], frame.sim.d[1]);
  }
}

/// Writes the acceleration of every particle to x[1].
template <class T, class Exec>
void run_accelerations(Exec& exec, const Frame<T>& frame) {
  StepParams<T> step = step_params(frame, 0);
  step.update = Update::acceleration;
  exec.frame([&](const auto& team) {
    advance(team, frame.sim, buffers(frame.sim, frame.position_form), step);
  });
}

/// The first substep of a frame, into memory of its own.
template <class T, class Exec>
void run_probe(Exec& exec, const Frame<T>& frame, Vec3Array<T> x, Vec3Array<T> d) {
  ParticleBuffers<T> p = buffers(frame.sim, frame.position_form);
  p.x_out = x;
  p.d_out = d;
  exec.frame([&](const auto& team) {
    if (frame.by_block) {
      team.for_each_block(frame.sim.blocks, ReachOfBlocks<T>{frame.sim, frame.sim.x[0]});
      team.meet();
    }
    Simulation<T> sim = frame.sim;
    if (sim.contacts.state == nullptr) return advance(team, sim, p, step_params(frame, 0));
    sim.contacts.age = T(0);
    sim.contacts.still = T(0);
    sim.contacts.waits = Waits::every;
    advance_before_contact(team, sim, p, step_params(frame, 0));
    list_pairs(team, sim, p, p.x_out, frame.position_form, false);
    respond_to_contact(team, sim, p, step_params(frame, 0), false);
  });
}

/// Lists the pairs that are near now.
template <class T, class Exec>
void run_pairs(Exec& exec, const Frame<T>& frame) {
  exec.frame([&](const auto& team) {
    const ParticleBuffers<T> p = buffers(frame.sim, frame.position_form);
    list_pairs(team, frame.sim, p, p.x_in, frame.position_form, false);
  });
}

/// Vertices of one cloth into the caller's buffer.
template <class T, class Exec>
void run_write_vertices(Exec& exec, const VertexJob<T>& job) {
  exec.frame([&](const auto& team) {
    team.for_each_block((job.vertices + block_size - 1) / block_size, WriteVertices<T>{job});
    team.meet();
  });
}

/// Positions of one cloth to another origin.
template <class T, class Exec>
void run_shift(Exec& exec, const OriginJob<T>& job) {
  exec.frame([&](const auto& team) {
    team.for_each_block((job.particles + block_size - 1) / block_size, ShiftOrigin<T>{job});
    team.meet();
  });
}

/// Leaves a sum over the fixed tree in the returned element of `scratch`.
template <class T, class Exec, class Value>
const T* run_reduce(Exec& exec, const Value& value, int count, T* scratch) {
  const T* result = nullptr;
  exec.frame([&](const auto& team) {
    const T* sum = reduce(team, value, count, scratch);
    if (team.leads()) result = sum;
  });
  return result;
}

/// A survey without a step, for state that is new.
template <class T, class Exec>
void run_survey(Exec& exec, const Frame<T>& frame) {
  exec.frame([&](const auto& team) { survey(team, frame.sim, frame.position_form); });
}

/// Writes the normal of every vertex to x[1].
template <class T, class Exec>
void run_normals(Exec& exec, const Frame<T>& frame) {
  exec.frame([&](const auto& team) {
    const Simulation<T>& sim = frame.sim;
    for (int r = 0; r < sim.range_count; ++r) {
      const BlockRange range = sim.ranges[r];
      with_fan(range.kind, sim, [&](auto fan) {
        team.for_each_block(
            range.count, VertexNormals<T, decltype(fan)>{fan, sim.cloths, sim.block.cloth, sim.x[0],
                                                         sim.x[1], range.first});
      });
    }
    team.meet();
  });
}

template <class T, class Exec>
const T* run_sum(Exec& exec, const T* elements, int count, T* scratch) {
  return run_reduce(exec, ElementOf<T>{elements}, count, scratch);
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
