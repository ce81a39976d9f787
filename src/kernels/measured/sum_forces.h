// The sums of a substep in the formats that exist to be measured, in passes of their own: Georgii
// and Westermann 2005, section 4.2, third pass.
#pragma once

#include "kernels/accumulate.h"
#include "kernels/measured/sums.h"

namespace weft {
namespace WEFT_BACKEND_NS {
namespace measured {

/// The chunks of vertices of very many springs (kernels/hubs.h).
template <class T>
struct SumChunks {
  Simulation<T> sim;

  template <int N>
  WEFT_HD void operator()(int index, int lane0, Lanes<N> lanes) const {
    const Edges<T>& edges = sim.edges;
    const HubChunk chunk = sim.hubs.chunk[index];
    const int block = chunk.particle / block_size;
    const int of_cloth = sim.block.cloth[block];
    if (sim.activity != nullptr && sim.activity[of_cloth].asleep) return;
    if (block >= sim.rows.first_block) return;  // of a cloth that gathers
    with_sum(edges, sim.cloths[of_cloth], [&](const auto& s) {
      LaneVec3<T, N> sum;
      lanes.each([&](int l) WEFT_LANE { sum.set(l, {T(0), T(0), T(0)}); });
      for (int64_t e = chunk.first + lane0; e < chunk.end; e += block_size) {
        lanes.each([&](int l) WEFT_LANE {
          const Vec3<T> f = incident_force(edges.force, edges.incident[e + l]);
          sum.set(l, sum_of(s, sum.get(l), term_of(s, f)));
        });
      }
      const Vec3<T> whole{sum_of_lanes(s, sum.x, lanes), sum_of_lanes(s, sum.y, lanes),
                          sum_of_lanes(s, sum.z, lanes)};
      if (lane0 == 0) sim.hubs.force[index] = whole;
    });
  }
};

/// All springs of each particle of a block, its chunks last.
template <class T>
struct SumForces {
  Simulation<T> sim;

  static constexpr bool uneven = true;
  WEFT_HD int64_t work_before(int index) const {
    return incident_before(sim.edges, sim.edges.first_block, index);
  }

  template <int N>
  WEFT_HD void operator()(int index, int lane0, Lanes<N> lanes) const {
    const Edges<T>& edges = sim.edges;
    const int block = edges.first_block + index;
    const int of_cloth = sim.block.cloth[block];
    if (sim.activity != nullptr && sim.activity[of_cloth].asleep) return;
    with_sum(edges, sim.cloths[of_cloth], [&](const auto& s) {
      LaneVec3<T, N> total;
      lanes.each([&](int l) WEFT_LANE { total.set(l, {T(0), T(0), T(0)}); });
      for (int64_t e = edges.start[index] + lane0; e < edges.start[index + 1]; e += block_size) {
        lanes.each([&](int l) WEFT_LANE {
          const Vec3<T> f = incident_force(edges.force, edges.incident[e + l]);
          total.set(l, sum_of(s, total.get(l), term_of(s, f)));
        });
      }
      if (sim.hubs.of_block != nullptr) add_chunks(s, block, lane0, lanes, total);
      const int t0 = index * block_size + lane0;
      lanes.each([&](int l) WEFT_LANE { store(edges.total, t0 + l, result_of(s, total.get(l))); });
    });
  }

 private:
  template <class Sum, int N>
  WEFT_HD_COLD void add_chunks(const Sum& s, int block, int lane0, Lanes<N>,
                               LaneVec3<T, N>& total) const {
    const Hubs<T>& hubs = sim.hubs;
    for (int h = hubs.of_block[block]; h < hubs.count; ++h) {
      const Hub hub = hubs.hub[h];
      if (hub.particle >= (block + 1) * block_size) return;
      const int l = hub.particle - block * block_size - lane0;
      if (l < 0 || l >= N) continue;
      Vec3<T> sum = total.get(l);
      for (int c = hub.first_chunk; c < hub.end_chunk; ++c) sum = sum_of(s, sum, hubs.force[c]);
      total.set(l, sum);
    }
  }
};

/// After a substep in float24_all: what is stored has no more digits either.
template <class T>
struct RoundState {
  Edges<T> edges;
  ParticleBuffers<T> p;

  template <int N>
  WEFT_HD void operator()(int index, int lane0, Lanes<N> lanes) const {
    const int i0 = (edges.first_block + index) * block_size + lane0;
    lanes.each([&](int l) WEFT_LANE {
      store(p.x_out, i0 + l, from_float24(to_float24(load(p.x_out, i0 + l))));
      store(p.d_out, i0 + l, from_float24(to_float24(load(p.d_out, i0 + l))));
    });
  }
};

}  // namespace measured
}  // namespace WEFT_BACKEND_NS
}  // namespace weft
