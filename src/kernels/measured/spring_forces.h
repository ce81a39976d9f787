// The force of every spring in the formats that exist to be measured: kernels/edge_forces.h with
// what these need besides.
#pragma once

#include "base/atomic_words.h"
#include "kernels/edge_forces.h"
#include "kernels/measured/numbers.h"

namespace weft {
namespace WEFT_BACKEND_NS {
namespace measured {

/// Before the springs of a substep in fixed8.
template <class T>
struct ForgetLargest {
  unsigned long long* largest;
  template <int N>
  WEFT_HD void operator()(int, int lane0, Lanes<N>) const {
    if (lane0 == 0) *largest = 0;
  }
};

template <class T>
struct SpringForces {
  EdgeForces<T> native;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Simulation<T>& sim = native.sim;
    const Edges<T>& edges = sim.edges;
    const int of_cloth = edges.cloth[block];
    if (sim.activity != nullptr && sim.activity[of_cloth].asleep) return;
    const int e0 = block * block_size + lane0;
    LaneVec3<T, N> force;
    if (edges.accumulation == Accumulation::float24_all) {
      pull_in_float24(e0, lanes, force);
    } else {
      native.pull(e0, lanes, force);
    }
    native.damp(sim.cloths[of_cloth], e0, lanes, force);
    if (edges.accumulation == Accumulation::fixed8) find_largest(lanes, force);
    lanes.each([&](int l) WEFT_LANE { store(edges.force, e0 + l, force.get(l)); });
  }

 private:
  template <int N>
  WEFT_HD_COLD void pull_in_float24(int e0, Lanes<N> lanes, LaneVec3<T, N>& force) const {
    const Edges<T>& edges = native.sim.edges;
    const Vec3Array<T> x = native.p.x_in;
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<Float24<T>> to =
          to_float24(load(x, edges.b[e0 + l])) - to_float24(load(x, edges.a[e0 + l]));
      force.set(l, from_float24(spring_force(to, Float24<T>(edges.stiffness[e0 + l]),
                                             Float24<T>(edges.rest[e0 + l]))));
    });
  }

  template <int N>
  WEFT_HD_COLD void find_largest(Lanes<N> lanes, const LaneVec3<T, N>& force) const {
    T most[N];
    lanes.each([&](int l) WEFT_LANE { most[l] = square_root(dot(force.get(l), force.get(l))); });
    double largest = 0;
    for (int l = 0; l < N; ++l) largest = larger(largest, double(most[l]));
    unsigned long long bits;
    __builtin_memcpy(&bits, &largest, sizeof bits);
    // Doubles that are not negative are ordered as their bits.
    atomic_most(native.sim.edges.largest, bits);
  }
};

}  // namespace measured
}  // namespace WEFT_BACKEND_NS
}  // namespace weft
