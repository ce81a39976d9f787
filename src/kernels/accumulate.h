// How forces add up on a vertex: in the processor's own precision, and in those of 2005.
//
// A sum is three functions on scalars: `term` makes a force ready, `sum` adds one, `result` gives
// it back in N. Whatever the order of storage, terms come in ascending neighbour index.
#pragma once

#include "base/lanes.h"
#include "kernels/low_precision.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T>
struct NativeSum {
  WEFT_HD T term(T force) const { return force; }
  WEFT_HD T sum(T a, T b) const { return a + b; }
  WEFT_HD T result(T total) const { return total; }
};

/// Blending into half floats; a power of two keeps the forces of any scene in their range.
template <class T>
struct Float16Sum {
  T scale;
  WEFT_HD T term(T force) const { return rounded_to_half(scale * force); }
  WEFT_HD T sum(T a, T b) const { return rounded_to_half(a + b); }
  WEFT_HD T result(T total) const { return total / scale; }
};

template <class T>
struct Float24Sum {
  WEFT_HD T term(T force) const { return rounded<float24_digits>(force); }
  WEFT_HD T sum(T a, T b) const { return rounded<float24_digits>(a + b); }
  WEFT_HD T result(T total) const { return total; }
};

/// Blending into 8 bits with a sign: -127 to 127 steps of full scale / 127, saturating.
template <class T>
struct Fixed8Sum {
  T per_newton;  ///< steps; 0 where no spring pulls
  T step;        ///< N
  WEFT_HD static T clamped(T v) {
    const T low = v < T(-127) ? T(-127) : v;
    return low > T(127) ? T(127) : low;
  }
  WEFT_HD T term(T force) const {
    constexpr T shift =
        static_cast<T>(sizeof(T) == sizeof(double) ? 6755399441055744.0 : 12582912.0);
    return (clamped(force * per_newton) + shift) - shift;  // to the nearest integer
  }
  WEFT_HD T sum(T a, T b) const { return clamped(a + b); }
  WEFT_HD T result(T total) const { return total * step; }
};

template <class T, class Sum>
WEFT_HD Vec3<T> term_of(const Sum& s, Vec3<T> force) {
  return {s.term(force.x), s.term(force.y), s.term(force.z)};
}
template <class T, class Sum>
WEFT_HD Vec3<T> sum_of(const Sum& s, Vec3<T> a, Vec3<T> b) {
  return {s.sum(a.x, b.x), s.sum(a.y, b.y), s.sum(a.z, b.z)};
}
template <class T, class Sum>
WEFT_HD Vec3<T> result_of(const Sum& s, Vec3<T> total) {
  return {s.result(total.x), s.result(total.y), s.result(total.z)};
}

/// Calls `use` with the sum that a mode adds with. What is summed by atomics has no other.
template <class T, class Use>
WEFT_HD void with_sum(const Edges<T>& edges, const ClothParams<T>& cloth, Use use) {
  switch (edges.accumulation) {
    case Accumulation::float16:
      return use(Float16Sum<T>{cloth.half_scale});
    case Accumulation::float24:
    case Accumulation::float24_all:
      return use(Float24Sum<T>{});
    case Accumulation::fixed8: {
      double largest;
      __builtin_memcpy(&largest, edges.largest, sizeof largest);
      const double full = largest * edges.full_scale;
      // Below, steps would have no reciprocal in float.
      return use(Fixed8Sum<T>{full > 1e-36 ? T(127 / full) : T(0), T(full / 127)});
    }
    default:
      return use(NativeSum<T>{});
  }
}

/// Force of a spring on the particle whose row names it (state/edges.h).
template <class T>
WEFT_HD Vec3<T> incident_force(Vec3Array<T> forces, int32_t incident) {
  const bool second = incident < 0;
  const Vec3<T> f = load(forces, second ? ~incident : incident);
  return select(second, Vec3<T>{-f.x, -f.y, -f.z}, f);
}

/// Springs of the particles of `count` blocks from the first on, and as much again for each.
template <class T>
WEFT_HD int64_t incident_before(const Edges<T>& edges, int first_block, int count) {
  const int slice = first_block - edges.first_block;
  return edges.start[slice + count] - edges.start[slice] + int64_t(count) * block_size;
}

/// Adds the forces of the springs of each particle of a block; hubs: kernels/hubs.h.
template <class T, class Sum, int N>
WEFT_HD void sum_incident(const Edges<T>& edges, Vec3Array<T> forces, const Sum& s, int block,
                          int i0, Lanes<N> lanes, LaneVec3<T, N>& total) {
  const int slice = block - edges.first_block;
  for (int64_t e = edges.start[slice] + (i0 - block * block_size); e < edges.start[slice + 1];
       e += block_size) {
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> f = incident_force(forces, edges.incident[e + l]);
      total.set(l, sum_of(s, total.get(l), term_of(s, f)));
    });
  }
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
