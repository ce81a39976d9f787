#pragma once

#include "bench/bench.h"

namespace weft::bench {

/// What the public interface costs: a call, many cloths, and vertices on their way out.
std::vector<Row> run_api(bool quick, std::ostream& progress);

}  // namespace weft::bench
