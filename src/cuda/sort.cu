#include "cuda/sort.h"

#include <thrust/device_ptr.h>
#include <thrust/execution_policy.h>
#include <thrust/scan.h>
#include <thrust/sort.h>

namespace weft {
namespace WEFT_BACKEND_NS {

// Thrust reports a failing device by exceptions; none may leave the back end.
template <class Call>
static Status contained(const Call& call) {
  try {
    call();
  } catch (...) {
    return Status::device_lost;
  }
  return Status::ok;
}

Status sort_scan(const uint32_t* in, uint32_t* out, int count) {
  return contained(
      [&] { thrust::exclusive_scan(thrust::device, in, in + count, out, uint32_t(0)); });
}

Status sort_pairs(uint32_t* keys, uint32_t* values, int count) {
  return contained([&] { thrust::stable_sort_by_key(thrust::device, keys, keys + count, values); });
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
