// The one header that knows whose GPU runtime it is: cuda or hip, under common names.
#pragma once

#include "base/portability.h"

#if defined(WEFT_HIP)
#  include <hip/hip_runtime.h>
#  define WEFT_GPU(name) hip##name
#  define WEFT_GPU_PROPERTIES hipDeviceProp_t
#  define WEFT_LAUNCH_CONSTANT
#else
#  include <cuda_runtime.h>
#  define WEFT_GPU(name) cuda##name
#  define WEFT_GPU_PROPERTIES cudaDeviceProp
/// An argument whose address may be taken without a copy of it for every thread.
#  define WEFT_LAUNCH_CONSTANT __grid_constant__
#endif

#include "weft/core.hpp"

namespace weft {
namespace WEFT_BACKEND_NS {

using GpuError = WEFT_GPU(Error_t);
using GpuStream = WEFT_GPU(Stream_t);
using GpuProperties = WEFT_GPU_PROPERTIES;
constexpr GpuError gpu_success = WEFT_GPU(Success);

inline Status status_of(GpuError error) {
  return error == gpu_success ? Status::ok : Status::device_lost;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
