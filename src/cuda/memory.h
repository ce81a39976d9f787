// Memory of the GPU back end: the device's own; the caller's allocator is for the host.
#pragma once

#include "cuda/gpu_api.h"

namespace weft {
namespace WEFT_BACKEND_NS {

inline void* allocate_memory(const Allocator&, size_t bytes) {
  void* memory = nullptr;
  if (WEFT_GPU(Malloc)(&memory, bytes) != gpu_success) {
    (void)WEFT_GPU(GetLastError)();  // running out is no lasting failure
    return nullptr;
  }
  return memory;
}
inline void release_memory(const Allocator&, void* memory, size_t) { (void)WEFT_GPU(Free)(memory); }

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
