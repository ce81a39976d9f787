#pragma once

#include <cstddef>

namespace weft::bench {

#define WEFT_FLOOR_OF(level)                          \
  namespace floor_##level {                           \
    void run(float* data, size_t count, int rounds);  \
    void run(double* data, size_t count, int rounds); \
  }
WEFT_FLOOR_OF(v2)
WEFT_FLOOR_OF(v3)
WEFT_FLOOR_OF(v4)
#undef WEFT_FLOOR_OF

}  // namespace weft::bench
