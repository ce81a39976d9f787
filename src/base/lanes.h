// A block of 32 particles under one control flow.
//
// A kernel's operator() runs once per block on the CPU, with Lanes<32>, and once per thread of a
// warp on the GPU, with Lanes<1>. Only what stands inside `each` touches a particle; everything
// outside is uniform for the block and free to branch and loop:
//
//     for (int s = 0; s < spheres; ++s)             // uniform
//       lanes.each([&](int l) WEFT_LANE { ... });   // CPU: one vectorised loop over 32 lanes
//                                                   // GPU: this thread's lane
//
// No loop of run-time length and no effect branch may stand inside `each`: g++ then stops
// vectorising without a word, and a branch not taken costs what the effect costs.
#pragma once

#include "base/vec3.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <int N>
struct Lanes {
  template <class F>
  WEFT_HD void each(F f) const {
    WEFT_SIMD
    for (int l = 0; l < N; ++l) f(l);
  }
  /// The same without vectors, for what branches from lane to lane.
  template <class F>
  WEFT_HD void each_alone(F f) const {
    for (int l = 0; l < N; ++l) f(l);
  }
  /// Whether f(l) holds for any lane of this call: on the GPU, for the thread's own.
  template <class F>
  WEFT_HD bool any(F f) const {
    int found = 0;
    WEFT_SIMD_OR(found)
    for (int l = 0; l < N; ++l) found |= f(l) ? 1 : 0;
    return found != 0;
  }
};

/// One vector per lane that lives from stage to stage: registers on the GPU, first-level cache on
/// the CPU.
template <class T, int N>
struct LaneVec3 {
  alignas(N == 1 ? alignof(T) : 64) T x[N];
  alignas(N == 1 ? alignof(T) : 64) T y[N];
  alignas(N == 1 ? alignof(T) : 64) T z[N];

  WEFT_HD Vec3<T> get(int l) const { return {x[l], y[l], z[l]}; }
  WEFT_HD void set(int l, Vec3<T> v) {
    x[l] = v.x;
    y[l] = v.y;
    z[l] = v.z;
  }
};

/// Sum of one partial sum per lane, added in halves 16, 8, 4, 2, 1. Lane 0 returns it.
template <class T>
WEFT_HD T sum_of_lanes(T* partial, Lanes<block_size>) {
  for (int half = block_size / 2; half > 0; half /= 2) {
    WEFT_SIMD
    for (int l = 0; l < half; ++l) partial[l] += partial[l + half];
  }
  return partial[0];
}
template <class T>
WEFT_HD T sum_of_lanes(T* partial, Lanes<1>) {
  T sum = partial[0];
  for (int half = block_size / 2; half > 0; half /= 2) sum += WEFT_SHUFFLE_DOWN(sum, half);
  return sum;
}

/// Smallest (or largest) of one value per lane; lane 0 returns it.
template <class T>
WEFT_HD T smallest_of_lanes(T* value, Lanes<block_size>) {
  for (int half = block_size / 2; half > 0; half /= 2) {
    WEFT_SIMD
    for (int l = 0; l < half; ++l) value[l] = smaller(value[l], value[l + half]);
  }
  return value[0];
}
template <class T>
WEFT_HD T smallest_of_lanes(T* value, Lanes<1>) {
  T least = value[0];
  for (int half = block_size / 2; half > 0; half /= 2) {
    least = smaller(least, WEFT_SHUFFLE_DOWN(least, half));
  }
  return least;
}
template <class T, int N>
WEFT_HD T largest_of_lanes(T* value, Lanes<N> lanes) {
  for (int l = 0; l < N; ++l) value[l] = -value[l];
  return -smallest_of_lanes(value, lanes);
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
