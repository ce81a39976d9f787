#pragma once

#include "bench/bench.h"

namespace weft::bench {

std::vector<Row> run_mesh(bool quick, std::ostream& progress);

}  // namespace weft::bench
