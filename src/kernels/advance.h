// The kernel of a substep: forces | integration | tethers | colliders | pins, as stages of one
// pass.
//
// Inputs are the buffers of time n, outputs those of time n+1. A stage that a cloth does not need
// is a uniform branch not taken, once per block of 32 particles. A stage outside of `Set` is not in
// the kernel: a GPU runs the colliders as passes of their own (kernels/collide_pass.h).
#pragma once

#include "kernels/collide.h"
#include "kernels/grid_springs.h"
#include "kernels/mesh_springs.h"
#include "kernels/particle_stages.h"
#include "kernels/scatter_springs.h"
#include "kernels/tethers.h"
#include "kernels/touch.h"
#include "kernels/wind.h"
#include "state/stages.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T, class Springs, StageSet Set = every_stage>
struct AdvanceParticles {
  using Fan = typename Springs::Fan;
  ParticleStages<T> stages;
  Springs springs;
  Fan fan;
  int first_block;

  static constexpr bool uneven = Springs::uneven;
  WEFT_HD int64_t work_before(int index) const { return springs.work_before(first_block, index); }

  template <int N>
  WEFT_HD void operator()(int index, int lane0, Lanes<N> lanes) const {
    const int block = first_block + index;
    const int i0 = block * block_size + lane0;
    const Simulation<T>& sim = stages.sim;
    const StepParams<T>& step = stages.step;
    const int of_cloth = sim.block.cloth[block];
    const ClothParams<T>& cloth = sim.cloths[of_cloth];
    if constexpr (contains(Set, Stage::sleep)) {
      if (sim.activity != nullptr && sim.activity[of_cloth].asleep) {
        return stages.rest(sim.activity[of_cloth], i0, lanes);
      }
    }
    const bool moves = step.update == Update::summed || step.update == Update::position;
    if (moves && springs.stopped()) return stages.stand_still(i0, lanes);
    LaneVec3<T, N> force;
    springs.gather(cloth, stages.p, block, i0, lanes, force);
    if constexpr (contains(Set, Stage::forces)) {
      if (shift_to(Part::forces, cloth) != no_part) {
        stages.add_constant_forces(cloth, i0, lanes, force);
      }
    }
    if constexpr (contains(Set, Stage::spring_damping)) {
      if (cloth.spring_damping > T(0)) damp_springs(cloth, block, i0, lanes, force);
    }
    if constexpr (contains(Set, Stage::wind)) {
      if (cloth.in_wind) {
        blow(fan, cloth, stages.p, step, sim.inverse_mass, block, i0, lanes, force);
      }
    }
    // -- seam: forces | integration | tethers | colliders
    if constexpr (contains(Set, Stage::contacts)) {
      if (moves && sim.contacts.state != nullptr) {
        return integrate_for_contact(cloth, of_cloth, block, lane0, i0, lanes, force);
      }
    }
    if constexpr (contains(Set, Stage::colliders)) {
      if (sim.reach != nullptr && sim.activity != nullptr) {
        integrate_and_collide(cloth, sim.activity[of_cloth], block, i0, lanes, force);
      } else {
        integrate(cloth, Everywhere{}, i0, lanes, force);
      }
    } else {
      integrate(cloth, Everywhere{}, i0, lanes, force);
    }
    if (!moves) return;
    // -- seam: colliders | pins
    if constexpr (contains(Set, Stage::moving_pins)) {
      if (sim.places_pins && sim.pins.of_block[block] >= 0) {
        stages.place_pins(sim.pins.of_block[block] * block_size + lane0, i0, lanes);
      }
    }
  }

 private:
  /// Whether any particle of this call ended outside of the region.
  template <class Region, int N>
  WEFT_HD bool integrate(const ClothParams<T>& cloth, const Region& region, int i0, Lanes<N> lanes,
                         const LaneVec3<T, N>& force) const {
    const bool left = place(cloth, region, i0, lanes, force);
    if constexpr (contains(Set, Stage::tethers)) {
      const Update update = stages.step.update;
      const bool moves = update == Update::summed || update == Update::position;
      if (moves && shift_to(Part::tethers, cloth) != no_part) {
        return keep_tethered(stages, cloth, region, left, i0, lanes);
      }
    }
    return left;
  }

  template <class Region, int N>
  WEFT_HD bool place(const ClothParams<T>& cloth, const Region& region, int i0, Lanes<N> lanes,
                     const LaneVec3<T, N>& force) const {
    if constexpr (Springs::projected) {
      return stages.take_displacement(region, i0, lanes);
    } else {
      return stages.integrate(cloth, region, i0, lanes, force);
    }
  }

  /// Where particles meet each other, pins are placed first: whoever touches them sees them where
  /// they are. A block that has nobody near it goes on to its colliders; others wait for contact.
  template <int N>
  WEFT_HD_COLD void integrate_for_contact(const ClothParams<T>& cloth, int of_cloth, int block,
                                          int lane0, int i0, Lanes<N> lanes,
                                          const LaneVec3<T, N>& force) const {
    const Simulation<T>& sim = stages.sim;
    const Contacts<T>& contacts = sim.contacts;
    const ClothActivity<T>& activity = sim.activity[of_cloth];
    integrate(cloth, Everywhere{}, i0, lanes, force);
    if constexpr (contains(Set, Stage::moving_pins)) {
      if (sim.pins.of_block != nullptr && sim.pins.of_block[block] >= 0) {
        stages.place_pins(sim.pins.of_block[block] * block_size + lane0, i0, lanes);
      }
    }
    if (contacts.age > T(0) && has_outrun(contacts, stages.p.x_out, cloth.end, i0, lanes)) {
      atomic_most(&contacts.state->outrun, 1ull);
    }
    if (contacts.still > T(0) && has_strayed(contacts, stages.p.x_out, cloth.end, i0, lanes)) {
      atomic_most(&contacts.state->moved[contacts.substep % 2], contacts.substep);
    }
    if (waits_for_contact(contacts, block)) return;
    if constexpr (contains(Set, Stage::colliders)) {
      if (sim.reach == nullptr) return;
      const CollideStage<T> collide{sim, stages.p, stages.step};
      const Region<T> near = region_of(sim, cloth, activity, block, i0);
      const bool every = activity.nearness == Nearness::every || collide.has_left(near, i0, lanes);
      if (!every && meets_nothing(sim, activity, block)) return;
      collide(cloth, activity, every, near, block, i0, lanes);
    }
  }

  /// A block that stays in its region meets the colliders of its list, which often are none.
  template <int N>
  WEFT_HD void integrate_and_collide(const ClothParams<T>& cloth, const ClothActivity<T>& activity,
                                     int block, int i0, Lanes<N> lanes,
                                     const LaneVec3<T, N>& force) const {
    const Simulation<T>& sim = stages.sim;
    const Region<T> region = region_of(sim, cloth, activity, block, i0);
    const CollideStage<T> collide{sim, stages.p, stages.step};
    bool every = activity.nearness == Nearness::every;
    if (every) {
      integrate(cloth, Everywhere{}, i0, lanes, force);
    } else {
      every = integrate(cloth, region, i0, lanes, force);
      if (every && !region.is_full(lanes)) every = collide.has_left(region, i0, lanes);
      if (!every && meets_nothing(sim, activity, block)) return;
    }
    collide(cloth, activity, every, region, block, i0, lanes);
  }

  template <int N>
  WEFT_HD_COLD void damp_springs(const ClothParams<T>& cloth, int block, int i0, Lanes<N> lanes,
                                 LaneVec3<T, N>& force) const {
    const T per_dt = per_dt_of(stages.step, cloth);
    if (stages.step.position_form) {
      springs.template damp<true>(cloth, stages.p, per_dt, block, i0, lanes, force);
    } else {
      springs.template damp<false>(cloth, stages.p, per_dt, block, i0, lanes, force);
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
