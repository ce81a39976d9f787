// The loops of bench/layouts.h, compiled at every instruction level with the flags of the kernels.
#pragma once

#include <cstddef>
#include <cstdint>

namespace weft::bench {

/// Positions and displacements of a sheet by component, and what comes after them.
struct PlainSheet {
  int vertices;
  const float* x[3];
  float* next[3];
  float* d[3];
  float* force[3];            ///< each_once only
  float stiffness, a_factor;  ///< N/m; dt^2 / mass
};
struct PlainRows {
  const uint32_t* start;  ///< compressed only
  const int32_t* neighbour;
  const float* rest;
  int width;  ///< padded only
};

#define WEFT_DECLARE_LAYOUTS(level)                          \
  namespace level {                                          \
  void compressed(const PlainSheet&, const PlainRows&);      \
  void padded(const PlainSheet&, const PlainRows&);          \
  void once(const PlainSheet&, int columns, const float* r); \
  }
WEFT_DECLARE_LAYOUTS(layouts_v2)
WEFT_DECLARE_LAYOUTS(layouts_v3)
WEFT_DECLARE_LAYOUTS(layouts_v4)
#undef WEFT_DECLARE_LAYOUTS

}  // namespace weft::bench
