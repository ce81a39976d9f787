// Sort and scan of the GPU back end; compiled apart from the kernels, with Thrust.
#pragma once

#include "cuda/gpu_api.h"

namespace weft {
namespace WEFT_BACKEND_NS {

Status sort_scan(const uint32_t* in, uint32_t* out, int count);
Status sort_pairs(uint32_t* keys, uint32_t* values, int count);

/// The same behind what is in the stream, of keys below 2^bits: the host does not wait. `room`:
/// device memory, at least 2 * count words and what the library counts in; where it is too small,
/// memory is allocated, which waits. A failure is kept for sort_failure.
void enqueue_sort(uint32_t* keys, uint32_t* values, int count, int bits, uint32_t* room,
                  int64_t room_words, GpuStream);
/// That of the sorts that this thread has enqueued since the last call.
Status sort_failure();

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
