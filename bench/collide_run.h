#pragma once

#include <ostream>
#include <vector>

#include "bench/bench.h"

namespace weft::bench {

/// A sheet that stands on its edge, falls and folds onto itself, with ever shorter substeps and
/// several searches: what they miss on the way, what that leads to, and what they cost.
void append_folding(bool quick, std::ostream& progress, std::vector<Row>&);

}  // namespace weft::bench
