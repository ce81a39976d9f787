// Room that a fixed-tree reduction needs.
#pragma once

#include <cstddef>

namespace weft {

/// Elements of scratch memory for the sum of `count` values (step/reduce.h), the result among them.
constexpr size_t reduce_scratch(size_t count) {
  size_t total = 0;
  do {
    count = (count + 1023) / 1024;
    total += count;
  } while (count > 1);
  return total == 0 ? 1 : total;
}

}  // namespace weft
