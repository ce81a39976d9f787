// Capes of a character: small sheets beside many capsules that move and turn.
#pragma once

#include <ostream>
#include <vector>

#include "bench/bench.h"

namespace weft::bench {

/// Rows of the table of effects: what the capsules add to a cape, with the calls that move them.
void append_capes(int rounds, std::ostream& progress, std::vector<Row>&);

}  // namespace weft::bench
