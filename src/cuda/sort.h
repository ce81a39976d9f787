// Sort and scan of the GPU back end; compiled apart from the kernels, with Thrust.
#pragma once

#include "cuda/gpu_api.h"

namespace weft {
namespace WEFT_BACKEND_NS {

Status sort_scan(const uint32_t* in, uint32_t* out, int count);
Status sort_pairs(uint32_t* keys, uint32_t* values, int count);

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
