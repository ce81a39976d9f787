// What the precision of the sum of spring forces does to forces and to equilibrium.
#pragma once

#include "bench/bench.h"

namespace weft::bench {

std::vector<Row> run_accumulate(bool quick, std::ostream& progress);

}  // namespace weft::bench
