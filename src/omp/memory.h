// Memory of the host back end: the caller's allocator, plain copies.
#pragma once

#include <stdlib.h>
#include <string.h>

#include "weft/core.hpp"

namespace weft {
namespace WEFT_BACKEND_NS {

constexpr size_t memory_alignment = 128;

inline void* allocate_memory(const Allocator& host, size_t bytes) {
  if (host.allocate) return host.allocate(host.user, bytes, memory_alignment);
  const size_t whole = (bytes + memory_alignment - 1) / memory_alignment * memory_alignment;
  return aligned_alloc(memory_alignment, whole);
}
inline void release_memory(const Allocator& host, void* memory, size_t bytes) {
  if (host.deallocate) return host.deallocate(host.user, memory, bytes);
  free(memory);
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
