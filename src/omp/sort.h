// Sort and scan of the host back end; compiled once, apart from the kernels, with Thrust. `alone`:
// on the calling thread, without OpenMP.
#pragma once

#include <stdint.h>

namespace weft {
namespace omp {

void exclusive_scan(const uint32_t* in, uint32_t* out, int count, bool alone);
void stable_sort_by_key(uint32_t* keys, uint32_t* values, int count, bool alone);

}  // namespace omp
}  // namespace weft
