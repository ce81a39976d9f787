// The arithmetic floor of a force kernel: the same roots and divisions, nothing else, at the
// instruction level that the kernels run at.
#pragma once

#include <cstddef>

namespace weft::bench {

/// `rounds` times a square root and a division for each of `count` numbers; keeps them finite.
void roots_and_divisions(const char* isa, float* data, size_t count, int rounds);
void roots_and_divisions(const char* isa, double* data, size_t count, int rounds);

}  // namespace weft::bench
