// splitmix64, the generator of every random set-up: seed 1 gives 0.56656158, 0.74578176, ...
#pragma once

#include "reference/vec.h"

#include <cstdint>

namespace reference {

class SplitMix {
 public:
  explicit SplitMix(uint64_t seed) : state_(seed) {}

  uint64_t bits() {
    uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// In [0, 1), 53 bits.
  double uniform() { return double(bits() >> 11) * 0x1p-53; }

  /// Three draws in the order x, y, z, each in [-half_width, half_width).
  Vec noise(double half_width) {
    const double x = uniform(), y = uniform(), z = uniform();
    return 2 * half_width * Vec{x - 0.5, y - 0.5, z - 0.5};
  }

 private:
  uint64_t state_;
};

}  // namespace reference
