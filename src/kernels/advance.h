// The kernel of a substep: forces | integration | colliders | pins, as stages of one pass.
//
// Inputs are the buffers of time n, outputs those of time n+1. A stage that a cloth does not need
// is a uniform branch not taken, once per block of 32 particles.
#pragma once

#include "kernels/grid_springs.h"
#include "kernels/mesh_springs.h"
#include "kernels/particle_stages.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T, class Springs>
struct Advance {
  ParticleStages<T> stages;
  Springs springs;
  int first_block;

  template <int N>
  WEFT_HD void operator()(int index, int lane0, Lanes<N> lanes) const {
    const int block = first_block + index;
    const int i0 = block * block_size + lane0;
    const Simulation<T>& sim = stages.sim;
    const StepParams<T>& step = stages.step;
    const ClothParams<T>& cloth = sim.cloths[sim.block.cloth[block]];

    LaneVec3<T, N> force;
    springs.gather(cloth, stages.p, block, i0, lanes, force);
    if (cloth.force_offset != no_forces) stages.add_constant_forces(cloth, i0, lanes, force);
    if (cloth.spring_damping > T(0)) damp_springs(cloth, block, i0, lanes, force);
    // -- seam: forces | integration
    stages.integrate(cloth, i0, lanes, force);
    if (step.update != Update::summed && step.update != Update::position) return;
    // -- seam: integration | colliders
    stages.collide(cloth, i0, lanes);
    // -- seam: colliders | pins
    if (sim.block.pins != nullptr && sim.block.pins[block] >= 0) {
      stages.place_pins(sim.block.pins[block] * block_size + lane0, i0, lanes);
    }
  }

 private:
  template <int N>
  WEFT_HD_COLD void damp_springs(const ClothParams<T>& cloth, int block, int i0, Lanes<N> lanes,
                                 LaneVec3<T, N>& force) const {
    const T per_dt = stages.step.ratio / stages.step.dt;  // 1 / the step the displacements took
    if (stages.step.position_form) {
      springs.template damp<true>(cloth, stages.p, per_dt, block, i0, lanes, force);
    } else {
      springs.template damp<false>(cloth, stages.p, per_dt, block, i0, lanes, force);
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
