// Springs of meshes and networks: sliced rows (SELL-32).
//
// The block of 32 particles is the slice. Entry (k, lane) of a slice stands at start + k*32 + lane
// and is the lane's k-th neighbour in ascending caller index, so sums do not depend on storage
// order. Short rows are filled with the particle itself, which pulls nothing.
#pragma once

#include "base/portability.h"

namespace weft {

template <class T>
struct SlicedRows {
  const int64_t* start;      ///< per slice and one more: first entry; width = difference / 32
  const int32_t* neighbour;  ///< element of the particle at the other end
  const T* rest;             ///< m
  const T* stiffness;        ///< N/m; null where the cloth has one for all
  int first_block;           ///< block of slice 0
};

}  // namespace weft
