// Where the blocks are that meet each other, and how a list of near pairs expects them to go on.
#pragma once

#include "base/lanes.h"
#include "kernels/collide.h"
#include "kernels/displacement.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Position in the world, of one axis.
WEFT_HD double in_world(float x, double origin) { return static_cast<double>(x) + origin; }
WEFT_HD double in_world(double x, double origin) { return x + origin; }

/// Bounds of where each block is and how it goes on from there; what is not finite does not count.
/// A list that is to last expects a particle to go on as it did on average since the last such list
/// was made, so that what only trembles does not outrun it.
template <class T, bool Position>
struct ContactBounds {
  Simulation<T> sim;
  ParticleBuffers<T> p;
  Vec3Array<T> x;
  bool lasting;
  int since;  ///< substeps since `from` and `drift` were written; below 1: never
  int given;  ///< as in PlanCells

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const int i0 = block * block_size + lane0;
    const int of_cloth = sim.block.cloth[block];
    if (lasting) expect(block, i0, lanes);
    const int last = sim.cloths[of_cloth].end - 1;
    const T far = T(3e38);
    const Vec3Array<T> positions = x, drift = sim.contacts.drift;
    const T* skins = sim.contacts.skin_of;
    LaneVec3<T, N> low, high, slow, fast;
    T skin[N];
    lanes.each([&](int l) WEFT_LANE {
      const int i = i0 + l < last ? i0 + l : last;  // padding stands for the last particle
      skin[l] = lasting ? skins[i] : T(0);
      const Vec3<T> at = load(positions, i), none{T(0), T(0), T(0)};
      const Vec3<T> d = lasting ? load(drift, i) : none;
      const T zero = (at.x - at.x) + (at.y - at.y) + (at.z - at.z);
      const bool finite = zero == T(0);
      const Vec3<T> plus{far, far, far}, minus{-far, -far, -far};
      low.set(l, select(finite, at, plus));
      high.set(l, select(finite, at, minus));
      slow.set(l, select(finite, d, plus));
      fast.set(l, select(finite, d, minus));
    });
    const double* origin = sim.contacts.cloth[of_cloth].origin;
    ContactBox box;
    box.low[0] = in_world(smallest_of_lanes(low.x, lanes), origin[0]);
    box.low[1] = in_world(smallest_of_lanes(low.y, lanes), origin[1]);
    box.low[2] = in_world(smallest_of_lanes(low.z, lanes), origin[2]);
    box.high[0] = in_world(largest_of_lanes(high.x, lanes), origin[0]);
    box.high[1] = in_world(largest_of_lanes(high.y, lanes), origin[1]);
    box.high[2] = in_world(largest_of_lanes(high.z, lanes), origin[2]);
    box.slowest[0] = static_cast<double>(smallest_of_lanes(slow.x, lanes));
    box.slowest[1] = static_cast<double>(smallest_of_lanes(slow.y, lanes));
    box.slowest[2] = static_cast<double>(smallest_of_lanes(slow.z, lanes));
    box.fastest[0] = static_cast<double>(largest_of_lanes(fast.x, lanes));
    box.fastest[1] = static_cast<double>(largest_of_lanes(fast.y, lanes));
    box.fastest[2] = static_cast<double>(largest_of_lanes(fast.z, lanes));
    box.most_skin = static_cast<double>(largest_of_lanes(skin, lanes));
    if (lane0 == 0) sim.contacts.box[block] = box;
  }

 private:
  /// Whether a collider or other particles may stop what is in the block.
  WEFT_HD bool may_be_stopped(int block) const {
    if (sim.contacts.row_width[block] > 0) return true;
    if (sim.reach == nullptr) return false;
    const ClothActivity<T>& activity = sim.activity[sim.block.cloth[block]];
    return activity.nearness == Nearness::every || !meets_nothing(sim, activity, block);
  }

  /// Who may be stopped gets a skin that it can stop in.
  template <int N>
  WEFT_HD void expect(int block, int i0, Lanes<N> lanes) const {
    const ContactState& state = *sim.contacts.state;
    const T usual = T(sim.contacts.skin);
    const T most = may_be_stopped(block) ? T(sim.contacts.most_stop) : T(0);
    const T ahead = T(given > 0 ? given : state.limit);
    const Vec3<T> calm{T(state.calm[0]), T(state.calm[1]), T(state.calm[2])};
    T* skins = sim.contacts.skin_of;
    const ParticleBuffers<T> buffers = p;
    const Vec3Array<T> now = x, from = sim.contacts.from, drift = sim.contacts.drift;
    if (since < 1) {
      lanes.each([=](int l) WEFT_LANE {
        store(drift, i0 + l, displacement<Position>(buffers, i0 + l));
        store(from, i0 + l, load(now, i0 + l));
        skins[i0 + l] = usual;
      });
      return;
    }
    const T per_substep = T(1) / T(since), age = T(since);
    const T much2 = T(0.25) * usual * usual;
    lanes.each([=](int l) WEFT_LANE {
      const Vec3<T> at = load(now, i0 + l), way = at - load(from, i0 + l);
      const Vec3<T> off = way - age * load(drift, i0 + l);
      const Vec3<T> d = displacement<Position>(buffers, i0 + l);
      // Who was stopped, or pushed, goes on as it does now.
      store(drift, i0 + l, select(dot(off, off) > much2, d, per_substep * way));
      store(from, i0 + l, at);
      const Vec3<T> speed = d - calm;
      skins[i0 + l] = usual + smaller(most, ahead * square_root(dot(speed, speed)));
    });
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
