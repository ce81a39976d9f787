// How forces add up in the formats of 2005.
//
// A sum is three functions on scalars: `term` makes a force ready, `sum` adds one, `result` gives
// it back in N. Whatever the order of storage, terms come in ascending neighbour index.
#pragma once

#include "base/lanes.h"
#include "kernels/measured/numbers.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {
namespace measured {

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

/// Blending into 8 bits with a sign: -127 to 127 quanta of full scale / 127, saturating.
template <class T>
struct Fixed8Sum {
  T per_newton;  ///< quanta; 0 where no spring pulls
  T quantum;     ///< N
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
  WEFT_HD T result(T total) const { return total * quantum; }
};

/// Calls `use` with the sum of a format.
template <class T, class Use>
WEFT_HD void with_sum(const Edges<T>& edges, const ClothParams<T>& cloth, Use use) {
  if (edges.accumulation == Accumulation::float16) return use(Float16Sum<T>{cloth.half_scale});
  if (edges.accumulation != Accumulation::fixed8) return use(Float24Sum<T>{});
  double largest;
  __builtin_memcpy(&largest, edges.largest, sizeof largest);
  const double full = largest * edges.full_scale;
  // Below, quanta would have no reciprocal in float.
  use(Fixed8Sum<T>{full > 1e-36 ? T(127 / full) : T(0), T(full / 127)});
}

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

/// sum_of_lanes with any sum.
template <class T, class Sum>
WEFT_HD T sum_of_lanes(const Sum& s, T* partial, Lanes<block_size>) {
  for (int half = block_size / 2; half > 0; half /= 2) {
    WEFT_SIMD
    for (int l = 0; l < half; ++l) partial[l] = s.sum(partial[l], partial[l + half]);
  }
  return partial[0];
}
template <class T, class Sum>
WEFT_HD T sum_of_lanes(const Sum& s, T* partial, Lanes<1>) {
  T sum = partial[0];
  for (int half = block_size / 2; half > 0; half /= 2) {
    sum = s.sum(sum, WEFT_SHUFFLE_DOWN(sum, half));
  }
  return sum;
}

}  // namespace measured
}  // namespace WEFT_BACKEND_NS
}  // namespace weft
