// Colliders | pins as a pass of their own, after the positions are written: for a GPU, where a
// stage that needs many registers would take them from the whole kernel it is part of.
#pragma once

#include "kernels/collide.h"
#include "kernels/particle_stages.h"
#include "kernels/touch.h"
#include "state/stages.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T, Meets what>
struct CollidePass {
  ParticleStages<T> stages;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const int i0 = block * block_size + lane0;
    const Simulation<T>& sim = stages.sim;
    const int of_cloth = sim.block.cloth[block];
    const ClothActivity<T>& activity = sim.activity[of_cloth];
    if constexpr (contains(every_stage, Stage::sleep)) {
      if (activity.asleep) return;
    }
    if (sim.contacts.state != nullptr && !waits_for_contact(sim.contacts, block)) return;
    if constexpr (contains(every_stage, Stage::colliders)) {
      collide(sim.cloths[of_cloth], activity, block, i0, lanes);
    }
    if constexpr (contains(every_stage, Stage::moving_pins)) {
      if (sim.places_pins && sim.pins.of_block[block] >= 0) {
        stages.place_pins(sim.pins.of_block[block] * block_size + lane0, i0, lanes);
      }
    }
  }

 private:
  template <int N>
  WEFT_HD void collide(const ClothParams<T>& cloth, const ClothActivity<T>& activity, int block,
                       int i0, Lanes<N> lanes) const {
    const CollideStage<T, what> stage{stages.sim, stages.p, stages.step};
    const Region<T> region = region_of(stages.sim, cloth, activity, block, i0);
    const bool every = activity.nearness == Nearness::every || stage.has_left(region, i0, lanes);
    if (!every && meets_nothing(stages.sim, activity, block)) return;
    stage(cloth, activity, every, region, block, i0, lanes);
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
