// Gather against scatter: Georgii and Westermann 2005, tables 1 and 2, on regular and irregular
// meshes.
#pragma once

#include "bench/bench.h"

namespace weft::bench {

std::vector<Row> run_forces(bool quick, std::ostream& progress);

}  // namespace weft::bench
