// Atomic words of host code that may not include <atomic>: its inline functions would be compiled
// at several instruction levels under one name.
#pragma once

#include "base/portability.h"

namespace weft {
namespace WEFT_BACKEND_NS {

inline int atomic_load(const int* word) { return __atomic_load_n(word, __ATOMIC_ACQUIRE); }
inline void atomic_store(int* word, int value) { __atomic_store_n(word, value, __ATOMIC_RELEASE); }
/// Adds and returns the sum.
inline int atomic_add(int* word, int value) {
  return __atomic_add_fetch(word, value, __ATOMIC_ACQ_REL);
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
