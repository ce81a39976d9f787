// Stretch per millisecond: every method over its substeps and stiffness, and what it does to the
// motion beside.
#pragma once

#include "bench/bench.h"

namespace weft::bench {

std::vector<Row> run_stretch(bool quick, std::ostream& progress);

}  // namespace weft::bench
