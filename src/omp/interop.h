// Access to device memory from the host. Here the two are one. Nothing to copy may come with null
// pointers, which memcpy must not see.
#pragma once

#include <string.h>

#include "weft/core.hpp"

namespace weft {
namespace WEFT_BACKEND_NS {

inline Status copy_to_device(void* device, const void* host, size_t bytes) {
  if (bytes > 0) memcpy(device, host, bytes);
  return Status::ok;
}
inline Status copy_to_host(void* host, const void* device, size_t bytes) {
  if (bytes > 0) memcpy(host, device, bytes);
  return Status::ok;
}
inline Status zero_device(void* device, size_t bytes) {
  if (bytes > 0) memset(device, 0, bytes);
  return Status::ok;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
