// A triangle mesh whose valences differ, with as many vertices and edges as the regular one.
#pragma once

#include "bench/sheets.h"

namespace weft::bench {

/// The n x n sheet of triangle_sheet after random edge flips, each of which keeps the counts and
/// leaves every valence from 3 to 12; the spread of valences is that of the uniform distribution to
/// a good part. `shuffled`: vertices carry random numbers.
TriangleSheet irregular_sheet(uint32_t n, bool shuffled);

struct Valences {
  uint32_t least, most;
};
Valences valences_of(const TriangleSheet&);

}  // namespace weft::bench
