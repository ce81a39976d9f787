// Additions and extremes that many lanes make on one word of device memory, in any order. Integers
// do not mind the order, floats do.
#pragma once

#include "base/portability.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T>
inline void host_atomic_sum(T* word, T value) {
  T old;
  __atomic_load(word, &old, __ATOMIC_RELAXED);
  T sum = old + value;
  while (!__atomic_compare_exchange(word, &old, &sum, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
    sum = old + value;
  }
}
/// `beats`: whether the value takes the place of what is there.
template <class T, class Beats>
inline void host_atomic_replace(T* word, T value, Beats beats) {
  T old;
  __atomic_load(word, &old, __ATOMIC_RELAXED);
  while (beats(value, old) && !__atomic_compare_exchange(word, &old, &value, false,
                                                         __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
  }
}
template <class T>
inline void host_atomic_least(T* word, T value) {
  host_atomic_replace(word, value, [](T a, T b) { return a < b; });
}
template <class T>
inline void host_atomic_most(T* word, T value) {
  host_atomic_replace(word, value, [](T a, T b) { return a > b; });
}

WEFT_HD void atomic_sum(float* word, float value) {
  WEFT_DEVICE_OR_HOST(atomicAdd(word, value), host_atomic_sum(word, value));
}
WEFT_HD void atomic_sum(double* word, double value) {
  WEFT_DEVICE_OR_HOST(atomicAdd(word, value), host_atomic_sum(word, value));
}
/// Two's complement: a signed value is added through its bits.
WEFT_HD void atomic_sum(unsigned long long* word, unsigned long long value) {
  WEFT_DEVICE_OR_HOST(atomicAdd(word, value),
                      (void)__atomic_fetch_add(word, value, __ATOMIC_RELAXED));
}
/// Adds, and returns what was there before.
WEFT_HD unsigned long long atomic_take(unsigned long long* word, unsigned long long value) {
  return WEFT_DEVICE_OR_HOST(atomicAdd(word, value),
                             __atomic_fetch_add(word, value, __ATOMIC_RELAXED));
}
WEFT_HD void atomic_least(unsigned long long* word, unsigned long long value) {
  WEFT_DEVICE_OR_HOST(atomicMin(word, value), host_atomic_least(word, value));
}
WEFT_HD void atomic_most(unsigned long long* word, unsigned long long value) {
  WEFT_DEVICE_OR_HOST(atomicMax(word, value), host_atomic_most(word, value));
}

/// Doubles as unsigned integers of the same order, and back.
WEFT_HD unsigned long long ordered(double value) {
  unsigned long long bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return (bits >> 63) != 0 ? ~bits : bits | 1ull << 63;
}
WEFT_HD double unordered(unsigned long long order) {
  const unsigned long long bits = (order >> 63) != 0 ? order & ~(1ull << 63) : ~order;
  double value;
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
