// The force of every spring, each once, and its way to the two ends: Georgii and Westermann 2005,
// section 4.2. Blocks are 32 springs.
#pragma once

#include "base/atomic_words.h"
#include "kernels/accumulate.h"
#include "kernels/displacement.h"
#include "kernels/integrate.h"
#include "kernels/spring.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T>
struct EdgeForces {
  Simulation<T> sim;
  ParticleBuffers<T> p;
  StepParams<T> step;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Edges<T>& edges = sim.edges;
    const int of_cloth = edges.cloth[block];
    const ClothParams<T>& cloth = sim.cloths[of_cloth];
    if (sim.activity != nullptr && sim.activity[of_cloth].asleep) return;
    const int e0 = block * block_size + lane0;
    LaneVec3<T, N> force;
    pull(e0, lanes, force);
    damp(cloth, e0, lanes, force);
    // -- seam: forces | where they go
    switch (edges.accumulation) {
      case Accumulation::atomic:
        return add_atomically(e0, lanes, force);
      case Accumulation::fixed64:
        return add_fixed(cloth, e0, lanes, force);
      default:
        lanes.each([&](int l) WEFT_LANE { store(edges.force, e0 + l, force.get(l)); });
    }
  }

  // The forces, one after the other: kernels/measured/spring_forces.h puts others between.
  template <int N>
  WEFT_HD void pull(int e0, Lanes<N> lanes, LaneVec3<T, N>& force) const {
    const Edges<T>& edges = sim.edges;
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> to = load(p.x_in, edges.b[e0 + l]) - load(p.x_in, edges.a[e0 + l]);
      force.set(l, spring_force(to, edges.stiffness[e0 + l], edges.rest[e0 + l]));
    });
  }

  template <int N>
  WEFT_HD void damp(const ClothParams<T>& cloth, int e0, Lanes<N> lanes,
                    LaneVec3<T, N>& force) const {
    if (!(cloth.spring_damping > T(0))) return;
    if (step.position_form) {
      add_damping<true>(cloth, e0, lanes, force);
    } else {
      add_damping<false>(cloth, e0, lanes, force);
    }
  }

 private:
  /// In the native mode damping is a sum of its own, as in the gather, where constant forces come
  /// between.
  template <bool Position, int N>
  WEFT_HD_COLD void add_damping(const ClothParams<T>& cloth, int e0, Lanes<N> lanes,
                                LaneVec3<T, N>& force) const {
    const Edges<T>& edges = sim.edges;
    const T per_dt = per_dt_of(step, cloth);
    LaneVec3<T, N> damping;
    lanes.each([&](int l) WEFT_LANE {
      const int a = edges.a[e0 + l], b = edges.b[e0 + l];
      const Vec3<T> to = load(p.x_in, b) - load(p.x_in, a);
      const Vec3<T> velocity =
          per_dt * (displacement<Position>(p, b) - displacement<Position>(p, a));
      damping.set(l, spring_damping_force(to, velocity, cloth.spring_damping));
    });
    if (edges.damping.data != nullptr) {
      lanes.each([&](int l) WEFT_LANE { store(edges.damping, e0 + l, damping.get(l)); });
    } else {
      lanes.each([&](int l) WEFT_LANE { force.set(l, force.get(l) + damping.get(l)); });
    }
  }

  template <int N>
  WEFT_HD_COLD void add_atomically(int e0, Lanes<N> lanes, const LaneVec3<T, N>& force) const {
    const Edges<T>& edges = sim.edges;
    const int first = edges.first_block * block_size;
    lanes.each_alone([&](int l) {
      const Vec3<T> f = force.get(l);
      T* a = edges.total.data + (edges.a[e0 + l] - first) * vector_stride;
      T* b = edges.total.data + (edges.b[e0 + l] - first) * vector_stride;
      const size_t pitch = edges.total.pitch;
      atomic_sum(a, f.x);
      atomic_sum(a + pitch, f.y);
      atomic_sum(a + 2 * pitch, f.z);
      atomic_sum(b, -f.x);
      atomic_sum(b + pitch, -f.y);
      atomic_sum(b + 2 * pitch, -f.z);
    });
  }

  /// Whole units of 1/fixed_scale N. A spring that takes more than its share of the range is
  /// reported and adds nothing: no sum can wrap.
  template <int N>
  WEFT_HD_COLD void add_fixed(const ClothParams<T>& cloth, int e0, Lanes<N> lanes,
                              const LaneVec3<T, N>& force) const {
    const Edges<T>& edges = sim.edges;
    const int first = edges.first_block * block_size;
    lanes.each_alone([&](int l) {
      const Vec3<T> f = cloth.fixed_scale * force.get(l);
      const T most =
          larger(larger(f.x < T(0) ? -f.x : f.x, f.y < T(0) ? -f.y : f.y), f.z < T(0) ? -f.z : f.z);
      if (!(most <= cloth.fixed_limit) || f.x != f.x || f.y != f.y || f.z != f.z) {
        const auto substep = static_cast<unsigned long long>(step.substep);
        atomic_least(edges.overflow, substep << 32 | static_cast<unsigned long long>(e0 + l));
        return;
      }
      unsigned long long* a = edges.fixed + 3 * int64_t(edges.a[e0 + l] - first);
      unsigned long long* b = edges.fixed + 3 * int64_t(edges.b[e0 + l] - first);
      const unsigned long long x = whole(f.x), y = whole(f.y), z = whole(f.z);
      atomic_sum(a, x);
      atomic_sum(a + 1, y);
      atomic_sum(a + 2, z);
      atomic_sum(b, 0 - x);
      atomic_sum(b + 1, 0 - y);
      atomic_sum(b + 2, 0 - z);
    });
  }
  /// The nearest whole number, as bits.
  WEFT_HD static unsigned long long whole(T v) {
    const T half = v < T(0) ? T(-0.5) : T(0.5);
    return static_cast<unsigned long long>(static_cast<long long>(v + half));
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
