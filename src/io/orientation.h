// On which side of a plane a point is, without rounding.
#pragma once

#include "weft/core.hpp"

namespace weft::io {

/// Sign of det(a - d, b - d, c - d): 1, 0 or -1, exact for coordinates that are 0 or between 1e-90
/// and 1e90 in size.
int orientation(const double3& a, const double3& b, const double3& c, const double3& d);

}  // namespace weft::io
