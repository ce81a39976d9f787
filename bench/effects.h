#pragma once

#include "bench/bench.h"

namespace weft::bench {

/// What every effect costs on a scene that uses it, and on one where it has nothing to do.
std::vector<Row> run_effects(bool quick, std::ostream& progress);

}  // namespace weft::bench
