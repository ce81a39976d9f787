// How long the grid of self-collision takes to build: ours, Thrust's and std::sort's order.
#pragma once

#include "bench/bench.h"

namespace weft::bench {

std::vector<Row> run_grid_build(bool quick, std::ostream& progress);

}  // namespace weft::bench
