// The formats of vertex attributes, in integers and sums only: the same bits everywhere.
#pragma once

#include "base/vec3.h"

namespace weft {
namespace WEFT_BACKEND_NS {

WEFT_HD uint32_t bits_of(float f) {
  uint32_t bits;
  __builtin_memcpy(&bits, &f, sizeof bits);
  return bits;
}
WEFT_HD float float_of(uint32_t bits) {
  float f;
  __builtin_memcpy(&f, &bits, sizeof f);
  return f;
}

/// Half precision, rounded to nearest, ties to even; beyond 65,504 infinite; NaN stays one.
WEFT_HD uint16_t half_of(float f) {
  const uint32_t all = bits_of(f), magnitude = all & 0x7fffffffu;
  const uint32_t sign = (all >> 16) & 0x8000u;
  uint32_t half;
  if (magnitude >= 0x477ff000u) {  // 65,520 and more round to infinity
    half = magnitude > 0x7f800000u ? 0x7e00u : 0x7c00u;
  } else if (magnitude < 0x38800000u) {  // below 2^-14: adding 1/2 rounds at the right digit
    half = bits_of(float_of(magnitude) + 0.5f) - 0x3f000000u;
  } else {
    half = (magnitude - (112u << 23) + 0xfffu + ((magnitude >> 13) & 1u)) >> 13;
  }
  return static_cast<uint16_t>(sign | half);
}

/// A number of [-1, 1] as an integer of [-most, most], halves away from zero; NaN is 0.
WEFT_HD int snorm_of(float v, float most) {
  const float clamped = v > 1.0f ? 1.0f : v < -1.0f ? -1.0f : v == v ? v : 0.0f;
  const float scaled = clamped * most;
  return static_cast<int>(scaled + (scaled < 0.0f ? -0.5f : 0.5f));
}

struct Octahedral {
  float u, v;
};
/// A direction as a point of the unit octahedron, unfolded to a square (Meyer et al. 2010, "On
/// floating-point normal vectors"). Zero becomes the middle, which decodes to +z.
WEFT_HD Octahedral octahedral_of(Vec3<float> n) {
  const float ax = n.x < 0 ? -n.x : n.x, ay = n.y < 0 ? -n.y : n.y, az = n.z < 0 ? -n.z : n.z;
  const float sum = (ax + ay) + az;
  const float scale = sum > 0.0f ? 1.0f / sum : 0.0f;
  const float u = n.x * scale, v = n.y * scale;
  if (!(n.z < 0.0f)) return {u, v};
  const float bu = u < 0 ? -u : u, bv = v < 0 ? -v : v;
  return {(u < 0.0f ? -1.0f : 1.0f) * (1.0f - bv), (v < 0.0f ? -1.0f : 1.0f) * (1.0f - bu)};
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
