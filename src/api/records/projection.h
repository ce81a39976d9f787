// What XPBD needs of a cloth: its springs in colours, and how many substeps keep it from
// stretching.
#pragma once

#include "api/records/cloth.h"

namespace weft::api {

/// Colours the springs of a cloth that has just been made; throws InvalidInput where a vertex has
/// too many.
void choose_colours(const WorldDesc&, ClothRecord&);

/// s: substeps of this length keep the 99th percentile of the stretch below some 3 %, and of a
/// sheet that hangs from one side and swings below half of that. What one pass over the springs
/// leaves of a weight that hangs on a chain of n springs of length L goes as g h^2 n^2/L
/// (docs/solvers.md).
double usual_substep(const WorldDesc&, const ClothRecord&);

}  // namespace weft::api
