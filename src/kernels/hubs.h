// Vertices of very many springs: a block of lanes sums a chunk of their entries (state/springs.h).
//
// Lane l adds entries l, l + 32, ..., lanes are added in halves, and the particle adds its chunks
// in order: the tree of kernels/reduce.h, whose bits no number of threads changes.
#pragma once

#include "kernels/accumulate.h"
#include "kernels/displacement.h"
#include "kernels/spring.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Sum of one component per lane, in halves, with any sum; lane 0 returns it.
template <class T, class Sum>
WEFT_HD T halved(const Sum& s, T* partial, Lanes<block_size>) {
  for (int half = block_size / 2; half > 0; half /= 2) {
    WEFT_SIMD
    for (int l = 0; l < half; ++l) partial[l] = s.sum(partial[l], partial[l + half]);
  }
  return partial[0];
}
template <class T, class Sum>
WEFT_HD T halved(const Sum& s, T* partial, Lanes<1>) {
  T sum = partial[0];
  for (int half = block_size / 2; half > 0; half /= 2) {
    sum = s.sum(sum, WEFT_SHUFFLE_DOWN(sum, half));
  }
  return sum;
}

/// Writes the sum of `force(e)` over the entries of a chunk.
template <class T, class Sum, class Force, int N>
WEFT_HD void sum_chunk(const HubChunk& chunk, const Sum& s, Force force, int lane0, Lanes<N> lanes,
                       Vec3<T>& out) {
  LaneVec3<T, N> sum;
  lanes.each([&](int l) WEFT_LANE { sum.set(l, {T(0), T(0), T(0)}); });
  for (int64_t e = chunk.first + lane0; e < chunk.end; e += block_size) {
    lanes.each([&](int l)
                   WEFT_LANE { sum.set(l, sum_of(s, sum.get(l), term_of(s, force(e + l)))); });
  }
  const Vec3<T> whole{halved(s, sum.x, lanes), halved(s, sum.y, lanes), halved(s, sum.z, lanes)};
  if (lane0 == 0) out = whole;
}

/// One block per chunk. The springs of a particle that gathers are evaluated here; those of one
/// that scatters have been.
template <class T>
struct HubChunks {
  Simulation<T> sim;
  ParticleBuffers<T> p;
  StepParams<T> step;

  template <int N>
  WEFT_HD void operator()(int index, int lane0, Lanes<N> lanes) const {
    const HubChunk chunk = sim.hubs.chunk[index];
    const int of_cloth = sim.block.cloth[chunk.particle / block_size];
    const ClothParams<T>& cloth = sim.cloths[of_cloth];
    if (sim.activity != nullptr && sim.activity[of_cloth].asleep) return;
    Vec3<T>& force = sim.hubs.force[index];
    if (chunk.particle / block_size >= sim.rows.first_block) {
      gather(cloth, chunk, lane0, lanes, force);
      if (cloth.spring_damping > T(0)) {
        if (step.position_form) {
          damp<true>(cloth, chunk, lane0, lanes, sim.hubs.damping[index]);
        } else {
          damp<false>(cloth, chunk, lane0, lanes, sim.hubs.damping[index]);
        }
      }
      return;
    }
    const Edges<T>& edges = sim.edges;
    with_sum(edges, cloth, [&](const auto& s) {
      sum_chunk(
          chunk, s, [&](int64_t e) { return incident_force(edges.force, edges.incident[e]); },
          lane0, lanes, force);
    });
    if (cloth.spring_damping > T(0) && edges.damping.data != nullptr) {
      sum_chunk(
          chunk, NativeSum<T>{},
          [&](int64_t e) { return incident_force(edges.damping, edges.incident[e]); }, lane0, lanes,
          sim.hubs.damping[index]);
    }
  }

 private:
  template <int N>
  WEFT_HD void gather(const ClothParams<T>& cloth, const HubChunk& chunk, int lane0, Lanes<N> lanes,
                      Vec3<T>& out) const {
    const SlicedRows<T>& rows = sim.rows;
    const Vec3<T> here = load(p.x_in, chunk.particle);
    const T uniform = cloth.stiffness[0];
    if (rows.stiffness != nullptr) {
      const auto force = [&](int64_t e) WEFT_LANE {
        return spring_force(load(p.x_in, rows.neighbour[e]) - here, rows.stiffness[e],
                            rows.rest[e]);
      };
      sum_chunk(chunk, NativeSum<T>{}, force, lane0, lanes, out);
    } else {
      const auto force = [&](int64_t e) WEFT_LANE {
        return spring_force(load(p.x_in, rows.neighbour[e]) - here, uniform, rows.rest[e]);
      };
      sum_chunk(chunk, NativeSum<T>{}, force, lane0, lanes, out);
    }
  }

  template <bool Position, int N>
  WEFT_HD_COLD void damp(const ClothParams<T>& cloth, const HubChunk& chunk, int lane0,
                         Lanes<N> lanes, Vec3<T>& out) const {
    const T per_dt = step.ratio / step.dt;
    const Vec3<T> here = load(p.x_in, chunk.particle);
    const Vec3<T> moved = displacement<Position>(p, chunk.particle);
    const auto force = [&](int64_t e) WEFT_LANE {
      const int j = sim.rows.neighbour[e];
      const Vec3<T> velocity = per_dt * (displacement<Position>(p, j) - moved);
      return spring_damping_force(load(p.x_in, j) - here, velocity, cloth.spring_damping);
    };
    sum_chunk(chunk, NativeSum<T>{}, force, lane0, lanes, out);
  }
};

/// Adds the chunks of the hubs of a block, which are few, to their particles.
template <class T, class Sum, int N>
WEFT_HD_COLD void add_hubs(const Hubs<T>& hubs, const Vec3<T>* chunks, const Sum& s, int block,
                           int i0, Lanes<N>, LaneVec3<T, N>& total) {
  for (int h = hubs.of_block[block]; h < hubs.count; ++h) {
    const Hub hub = hubs.hub[h];
    if (hub.particle >= (block + 1) * block_size) return;
    const int l = hub.particle - i0;
    if (l < 0 || l >= N) continue;
    Vec3<T> sum = total.get(l);
    for (int c = hub.first_chunk; c < hub.end_chunk; ++c) sum = sum_of(s, sum, chunks[c]);
    total.set(l, sum);
  }
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
