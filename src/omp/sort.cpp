#include "omp/sort.h"

#include <thrust/execution_policy.h>
#include <thrust/scan.h>
#include <thrust/sort.h>

namespace weft {
namespace omp {

// Integers: the sum does not depend on the order in which threads add.
void exclusive_scan(const uint32_t* in, uint32_t* out, int count, bool alone) {
  if (alone) {
    thrust::exclusive_scan(thrust::seq, in, in + count, out, uint32_t(0));
  } else {
    thrust::exclusive_scan(thrust::device, in, in + count, out, uint32_t(0));
  }
}

void stable_sort_by_key(uint32_t* keys, uint32_t* values, int count, bool alone) {
  if (alone) {
    thrust::stable_sort_by_key(thrust::seq, keys, keys + count, values);
  } else {
    thrust::stable_sort_by_key(thrust::device, keys, keys + count, values);
  }
}

}  // namespace omp
}  // namespace weft
