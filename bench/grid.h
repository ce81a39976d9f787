#pragma once

#include "bench/bench.h"

namespace weft::bench {

std::vector<Row> run_grid(bool quick, std::ostream& progress);

}  // namespace weft::bench
