#pragma once

#include "bench/bench.h"

namespace weft::bench {

/// What the searches of self-collision find, and what they cost.
std::vector<Row> run_collide(bool quick, std::ostream& progress);

}  // namespace weft::bench
