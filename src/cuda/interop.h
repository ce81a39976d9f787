// Access to device memory from the host: copies that wait.
#pragma once

#include "cuda/gpu_api.h"

namespace weft {
namespace WEFT_BACKEND_NS {

inline Status copy_to_device(void* device, const void* host, size_t bytes) {
  return status_of(WEFT_GPU(Memcpy)(device, host, bytes, WEFT_GPU(MemcpyHostToDevice)));
}
inline Status copy_to_host(void* host, const void* device, size_t bytes) {
  return status_of(WEFT_GPU(Memcpy)(host, device, bytes, WEFT_GPU(MemcpyDeviceToHost)));
}
inline Status copy_on_device(void* to, const void* from, size_t bytes) {
  return status_of(WEFT_GPU(MemcpyAsync)(to, from, bytes, WEFT_GPU(MemcpyDeviceToDevice), nullptr));
}
inline Status zero_device(void* device, size_t bytes) {
  return status_of(WEFT_GPU(Memset)(device, 0, bytes));
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
