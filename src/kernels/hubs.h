// Vertices of very many springs: a block of lanes sums a chunk of their entries (state/springs.h).
//
// Lane l adds entries l, l + 32, ..., lanes are added in halves, and the particle adds its chunks
// in order: the tree of kernels/reduce.h, whose bits no number of threads changes.
#pragma once

#include "kernels/accumulate.h"
#include "kernels/displacement.h"
#include "kernels/integrate.h"
#include "kernels/spring.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Writes the sum of `force(e)` over the entries of a chunk.
template <class T, class Force, int N>
WEFT_HD void sum_chunk(const HubChunk& chunk, Force force, int lane0, Lanes<N> lanes,
                       Vec3<T>& out) {
  LaneVec3<T, N> sum;
  lanes.each([&](int l) WEFT_LANE { sum.set(l, {T(0), T(0), T(0)}); });
  for (int64_t e = chunk.first + lane0; e < chunk.end; e += block_size) {
    lanes.each([&](int l) WEFT_LANE { sum.set(l, sum.get(l) + force(e + l)); });
  }
  const Vec3<T> whole{sum_of_lanes(sum.x, lanes), sum_of_lanes(sum.y, lanes),
                      sum_of_lanes(sum.z, lanes)};
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
    sum_chunk(
        chunk, [&](int64_t e) { return incident_force(edges.force, edges.incident[e]); }, lane0,
        lanes, force);
    if (cloth.spring_damping > T(0) && edges.damping.data != nullptr) {
      sum_chunk(
          chunk, [&](int64_t e) { return incident_force(edges.damping, edges.incident[e]); }, lane0,
          lanes, sim.hubs.damping[index]);
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
      sum_chunk(chunk, force, lane0, lanes, out);
    } else {
      const auto force = [&](int64_t e) WEFT_LANE {
        return spring_force(load(p.x_in, rows.neighbour[e]) - here, uniform, rows.rest[e]);
      };
      sum_chunk(chunk, force, lane0, lanes, out);
    }
  }

  template <bool Position, int N>
  WEFT_HD_COLD void damp(const ClothParams<T>& cloth, const HubChunk& chunk, int lane0,
                         Lanes<N> lanes, Vec3<T>& out) const {
    const T per_dt = per_dt_of(step, cloth);
    const Vec3<T> here = load(p.x_in, chunk.particle);
    const Vec3<T> moved = displacement<Position>(p, chunk.particle);
    const auto force = [&](int64_t e) WEFT_LANE {
      const int j = sim.rows.neighbour[e];
      const Vec3<T> velocity = per_dt * (displacement<Position>(p, j) - moved);
      return spring_damping_force(load(p.x_in, j) - here, velocity, cloth.spring_damping);
    };
    sum_chunk(chunk, force, lane0, lanes, out);
  }
};

/// Adds the chunks of the hubs of a block, which are few, to their particles.
template <class T, int N>
WEFT_HD_COLD void add_hubs(const Hubs<T>& hubs, const Vec3<T>* chunks, int block, int i0, Lanes<N>,
                           LaneVec3<T, N>& total) {
  for (int h = hubs.of_block[block]; h < hubs.count; ++h) {
    const Hub hub = hubs.hub[h];
    if (hub.particle >= (block + 1) * block_size) return;
    const int l = hub.particle - i0;
    if (l < 0 || l >= N) continue;
    Vec3<T> sum = total.get(l);
    for (int c = hub.first_chunk; c < hub.end_chunk; ++c) sum = sum + chunks[c];
    total.set(l, sum);
  }
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
