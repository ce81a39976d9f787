#include "bench/floor_kernel.h"

#include <cmath>

namespace weft::bench::WEFT_FLOOR_NS {

template <class T>
static void pass(T* data, size_t count, int rounds) {
  // Independent chains: the divider is kept busy, latency does not count.
  for (size_t block = 0; block + 64 <= count; block += 64) {
    for (int r = 0; r < rounds; ++r) {
#pragma omp simd
      for (size_t i = block; i < block + 64; ++i) data[i] = T(2) / (T(1) + std::sqrt(data[i]));
    }
  }
}

void run(float* data, size_t count, int rounds) { pass(data, count, rounds); }
void run(double* data, size_t count, int rounds) { pass(data, count, rounds); }

}  // namespace weft::bench::WEFT_FLOOR_NS
