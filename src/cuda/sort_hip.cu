// cuda/sort.h for HIP: rocPRIM, whose radix sort is stable like Thrust's.
#include "cuda/sort.h"

#include "cuda/memory.h"

#include <rocprim/device/device_radix_sort.hpp>
#include <rocprim/device/device_scan.hpp>

namespace weft {
namespace WEFT_BACKEND_NS {

namespace {

/// Device memory for the length of one call; releasing it waits for the kernels that use it.
class Scratch {
 public:
  explicit Scratch(size_t bytes)
      : bytes_(bytes), memory_(bytes > 0 ? allocate_memory(Allocator{}, bytes) : nullptr) {}
  ~Scratch() {
    if (memory_ != nullptr) release_memory(Allocator{}, memory_, bytes_);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  explicit operator bool() const { return memory_ != nullptr; }
  void* data() const { return memory_; }
  uint32_t* words() const { return static_cast<uint32_t*>(memory_); }

 private:
  size_t bytes_;
  void* memory_;
};

// rocPRIM first tells how many bytes a call needs, then does it.
template <class Call>
Status with_scratch(const Call& call) {
  size_t bytes = 0;
  if (const GpuError error = call(nullptr, bytes); error != gpu_success) return status_of(error);
  const Scratch scratch(bytes);
  return scratch ? status_of(call(scratch.data(), bytes)) : Status::out_of_memory;
}

// A sort may leave its result in the other buffer of the two.
Status bring_home(uint32_t* home, const rocprim::double_buffer<uint32_t>& buffer, size_t bytes) {
  if (buffer.current() == home) return Status::ok;
  return status_of(WEFT_GPU(Memcpy)(home, buffer.current(), bytes, WEFT_GPU(MemcpyDeviceToDevice)));
}

}  // namespace

Status sort_scan(const uint32_t* in, uint32_t* out, int count) {
  if (count == 0) return Status::ok;
  return with_scratch([&](void* scratch, size_t& bytes) {
    return rocprim::exclusive_scan(scratch, bytes, in, out, uint32_t(0), size_t(count),
                                   rocprim::plus<uint32_t>());
  });
}

Status sort_pairs(uint32_t* keys, uint32_t* values, int count) {
  if (count == 0) return Status::ok;
  const size_t bytes = size_t(count) * sizeof(uint32_t);
  const Scratch other_keys(bytes), other_values(bytes);
  if (!other_keys || !other_values) return Status::out_of_memory;
  rocprim::double_buffer<uint32_t> key(keys, other_keys.words());
  rocprim::double_buffer<uint32_t> value(values, other_values.words());
  const Status sorted = with_scratch([&](void* scratch, size_t& needed) {
    return rocprim::radix_sort_pairs(scratch, needed, key, value, size_t(count));
  });
  if (sorted != Status::ok) return sorted;
  const Status moved = bring_home(keys, key, bytes);
  return moved == Status::ok ? bring_home(values, value, bytes) : moved;
}

namespace {

thread_local Status failure = Status::ok;

/// A sort may leave its result in the other buffer of the two.
GpuError bring_home(uint32_t* home, const rocprim::double_buffer<uint32_t>& buffer, size_t bytes,
                    GpuStream stream) {
  if (buffer.current() == home) return gpu_success;
  return WEFT_GPU(MemcpyAsync)(home, buffer.current(), bytes, WEFT_GPU(MemcpyDeviceToDevice),
                               stream);
}

/// `room` holds the other buffers, then what rocPRIM counts in.
GpuError sort_in_room(uint32_t* keys, uint32_t* values, int count, int bits, uint32_t* room,
                      int64_t room_words, GpuStream stream) {
  const size_t bytes = size_t(count) * sizeof(uint32_t);
  rocprim::double_buffer<uint32_t> key(keys, room), value(values, room + count);
  const auto call = [&](void* scratch, size_t& needed) {
    return rocprim::radix_sort_pairs(scratch, needed, key, value, size_t(count), 0,
                                     static_cast<unsigned>(bits), stream);
  };
  size_t needed = 0;
  if (const GpuError error = call(nullptr, needed); error != gpu_success) return error;
  const int64_t used = 2 * int64_t(count);
  const bool fits = int64_t(needed) <= (room_words - used) * int64_t(sizeof(uint32_t));
  const Scratch more(fits ? 0 : needed);
  if (!fits && !more) return WEFT_GPU(ErrorOutOfMemory);
  const GpuError sorted = call(fits ? room + used : more.data(), needed);
  if (sorted != gpu_success) return sorted;
  const GpuError moved = bring_home(keys, key, bytes, stream);
  return moved == gpu_success ? bring_home(values, value, bytes, stream) : moved;
}

}  // namespace

void enqueue_sort(uint32_t* keys, uint32_t* values, int count, int bits, uint32_t* room,
                  int64_t room_words, GpuStream stream) {
  if (count == 0) return;
  const GpuError error = sort_in_room(keys, values, count, bits, room, room_words, stream);
  if (error != gpu_success) failure = status_of(error);
}

Status sort_failure() {
  const Status found = failure;
  failure = Status::ok;
  return found;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
