#include "bench/floor.h"

#include "bench/floor_kernel.h"

namespace weft::bench {

template <class T>
static void dispatch(const char* isa, T* data, size_t count, int rounds) {
  if (isa[1] == '4') return floor_v4::run(data, count, rounds);
  if (isa[1] == '3') return floor_v3::run(data, count, rounds);
  floor_v2::run(data, count, rounds);
}

void roots_and_divisions(const char* isa, float* data, size_t count, int rounds) {
  dispatch(isa, data, count, rounds);
}
void roots_and_divisions(const char* isa, double* data, size_t count, int rounds) {
  dispatch(isa, data, count, rounds);
}

}  // namespace weft::bench
