// What a step costs on a GPU: by size, precision, number of cloths and effect.
#pragma once

#include "bench/bench.h"

namespace weft::bench {

/// No rows, and a line about the reason, where this build or this machine has no GPU.
std::vector<Row> run_gpu(bool quick, std::ostream& progress);

/// What the memory of device 0 gives to a plain copy: bytes read and written per second. Zero where
/// it cannot be measured.
double gpu_copy_bandwidth();

}  // namespace weft::bench
