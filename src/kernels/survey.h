// What the host wants to know of the particles after a frame: where they are, how fast the fastest
// is, whether any is lost, and a sample of them for their middle. Smallest and largest do not
// depend on the order: same bits anywhere.
#pragma once

#include "kernels/displacement.h"
#include "base/lanes.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T, bool Position>
struct SurveyParticles {
  Simulation<T> sim;
  ParticleBuffers<T> p;

  template <int N>
  WEFT_HD void operator()(int group, int lane0, Lanes<N> lanes) const {
    const SurveyRange range = sim.survey_ranges[group];
    const T far = T(3e38);
    LaneVec3<T, N> low, high;
    T furthest2[N];
    T broken[N];
    lanes.each([&](int l) WEFT_LANE {
      low.set(l, {far, far, far});
      high.set(l, {-far, -far, -far});
      furthest2[l] = T(0);
      broken[l] = T(0);
    });
    for (int i0 = range.first + lane0; i0 < range.end + lane0; i0 += block_size) {
      lanes.each([&](int l) WEFT_LANE {
        // Padding stands for the last particle.
        const int i = i0 + l < range.end ? i0 + l : range.end - 1;
        const Vec3<T> x = load(p.x_in, i), d = displacement<Position>(p, i);
        const T zero = (x.x - x.x) + (x.y - x.y) + (x.z - x.z);
        const Vec3<T> a = low.get(l), b = high.get(l);
        low.set(l, {smaller(x.x, a.x), smaller(x.y, a.y), smaller(x.z, a.z)});
        high.set(l, {larger(x.x, b.x), larger(x.y, b.y), larger(x.z, b.z)});
        furthest2[l] = larger(dot(d, d), furthest2[l]);
        broken[l] = zero == T(0) ? broken[l] : T(1);
      });
    }
    Survey<T> found{};
    const int last = range.end - 1 - range.first;
    for (int s = 0; s < survey_samples; ++s) {
      found.sample[s] = load(p.x_in, range.first + int(int64_t(last) * s / (survey_samples - 1)));
    }
    found.low = {smallest_of_lanes(low.x, lanes), smallest_of_lanes(low.y, lanes),
                 smallest_of_lanes(low.z, lanes)};
    found.high = {largest_of_lanes(high.x, lanes), largest_of_lanes(high.y, lanes),
                  largest_of_lanes(high.z, lanes)};
    found.furthest2 = largest_of_lanes(furthest2, lanes);
    found.broken = largest_of_lanes(broken, lanes) > T(0) ? 1 : 0;
    if (lane0 == 0) sim.survey[group] = found;
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
