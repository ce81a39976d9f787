// Numbers of fewer digits than the processor's own, computed in the processor's: what the graphics
// cards of 2005 added forces with (Georgii and Westermann 2005, section 5).
#pragma once

#include "base/vec3.h"

namespace weft {
namespace WEFT_BACKEND_NS {
namespace measured {

/// The nearest number of `Digits` significant bits, by Veltkamp's splitting: no exponent is lost
/// below 2^(126 - 24 + Digits), where the result is infinite or NaN.
template <int Digits, class T>
WEFT_HD T rounded(T v) {
  constexpr int own = sizeof(T) == sizeof(double) ? 53 : 24;
  constexpr T factor = static_cast<T>((uint64_t(1) << (own - Digits)) + 1);
  const T big = factor * v;
  return big - (big - v);
}

/// IEEE 754 half: 11 bits, at least in steps of 2^-24, infinite from 65520 on.
template <class T>
WEFT_HD T rounded_to_half(T v) {
  constexpr T shift = static_cast<T>(sizeof(T) == sizeof(double) ? 402653184.0 : 0.75);
  const T small = (v + shift) - shift;
  const T size = v < T(0) ? -v : v;
  const T normal = rounded<11>(v);
  const T kept = size < T(6.103515625e-5) ? small : normal;
  const T infinite = static_cast<T>(__builtin_huge_valf());
  const T beyond = v < T(0) ? -infinite : infinite;
  return size < T(65520) ? kept : beyond;
}

constexpr int float24_digits = 17;

/// A number of the 24-bit fragment units: 16 stored bits of the significand. Every operation
/// rounds.
template <class T>
struct Float24 {
  T value;
  Float24() = default;
  WEFT_HD explicit Float24(T v) : value(rounded<float24_digits>(v)) {}

  // Friends, so that they hide none of the operators of vectors from this namespace.
  friend WEFT_HD Float24 operator+(Float24 a, Float24 b) { return Float24(a.value + b.value); }
  friend WEFT_HD Float24 operator-(Float24 a, Float24 b) { return Float24(a.value - b.value); }
  friend WEFT_HD Float24 operator*(Float24 a, Float24 b) { return Float24(a.value * b.value); }
  friend WEFT_HD Float24 operator/(Float24 a, Float24 b) { return Float24(a.value / b.value); }
  friend WEFT_HD bool operator>(Float24 a, Float24 b) { return a.value > b.value; }
  friend WEFT_HD Float24 square_root(Float24 a) { return Float24(square_root(a.value)); }
};
template <class T>
WEFT_HD Vec3<Float24<T>> to_float24(Vec3<T> v) {
  return {Float24<T>(v.x), Float24<T>(v.y), Float24<T>(v.z)};
}
template <class T>
WEFT_HD Vec3<T> from_float24(Vec3<Float24<T>> v) {
  return {v.x.value, v.y.value, v.z.value};
}

}  // namespace measured
}  // namespace WEFT_BACKEND_NS
}  // namespace weft
