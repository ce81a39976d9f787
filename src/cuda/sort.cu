#include "cuda/sort.h"

#include "cuda/memory.h"

#include <thrust/device_ptr.h>
#include <thrust/execution_policy.h>
#include <thrust/scan.h>
#include <thrust/sort.h>
#include <thrust/system/cuda/execution_policy.h>

#include <new>

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

namespace {

/// Thrust's temporary memory, cut from room that is there already. Pieces are given back when the
/// call is over; what did not fit is then released.
class RoomAllocator {
 public:
  using value_type = char;

  RoomAllocator(uint32_t* room, int64_t words)
      : begin_(reinterpret_cast<char*>(room)),
        next_(begin_),
        end_(begin_ + words * int64_t(sizeof(uint32_t))) {}

  char* allocate(std::ptrdiff_t bytes) {
    const std::ptrdiff_t whole = (bytes + 255) / 256 * 256;
    if (whole <= end_ - next_) {
      char* const piece = next_;
      next_ += whole;
      return piece;
    }
    void* const memory = allocate_memory(Allocator{}, size_t(whole));
    if (memory == nullptr) throw std::bad_alloc();
    return static_cast<char*>(memory);
  }
  void deallocate(char* piece, size_t bytes) {
    const bool of_room = piece >= begin_ && piece < end_;
    if (!of_room) release_memory(Allocator{}, piece, bytes);
  }

 private:
  char *begin_, *next_, *end_;
};

thread_local Status failure = Status::ok;

}  // namespace

void enqueue_sort(uint32_t* keys, uint32_t* values, int count, int, uint32_t* room,
                  int64_t room_words, GpuStream stream) {
  RoomAllocator allocator(room, room_words);
  const Status sorted = contained([&] {
    thrust::stable_sort_by_key(thrust::cuda::par_nosync(allocator).on(stream), keys, keys + count,
                               values);
  });
  if (sorted != Status::ok) failure = sorted;
}

Status sort_failure() {
  const Status found = failure;
  failure = Status::ok;
  return found;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
