// The GPU back end: the kernels and the step of every other back end, compiled for the device.
#include "cuda/exec.cuh"
#include "cuda/interop.h"
#include "cuda/memory.h"
#include "cuda/sort.h"
#include "step/backend_of.h"

namespace weft {
namespace WEFT_BACKEND_NS {

struct GpuDevice {
  static BackendInfo& info() {
    static BackendInfo info{WEFT_BACKEND_NAME, "", "-", WEFT_VECTOR_STRIDE, false};
    return info;
  }
  // The default stream: copies wait for kernels and kernels for copies without a word.
  static Exec exec(int, Workers) { return Exec(nullptr); }
  static Status finish() {
    const GpuError launch = WEFT_GPU(GetLastError)();
    const Status sorts = sort_failure();
    const Status done =
        status_of(launch == gpu_success ? WEFT_GPU(StreamSynchronize)(nullptr) : launch);
    return done == Status::ok ? sorts : done;
  }

  static void* allocate(const Allocator& host, size_t bytes) {
    return allocate_memory(host, bytes);
  }
  static void release(const Allocator& host, void* memory, size_t bytes) {
    release_memory(host, memory, bytes);
  }
  static Status zero(void* device, size_t bytes) { return zero_device(device, bytes); }
  static Status to_device(void* device, const void* host, size_t bytes) {
    return copy_to_device(device, host, bytes);
  }
  static Status to_host(void* host, const void* device, size_t bytes) {
    return copy_to_host(host, device, bytes);
  }
  static Status copy(void* to, const void* from, size_t bytes) {
    return copy_on_device(to, from, bytes);
  }
  static Status exclusive_scan(const uint32_t* in, uint32_t* out, int count, Workers) {
    return sort_scan(in, out, count);
  }
  static Status stable_sort_by_key(uint32_t* keys, uint32_t* values, int count, Workers) {
    return sort_pairs(keys, values, count);
  }
};

}  // namespace WEFT_BACKEND_NS

/// Null with a reason where there is no usable device: every error of the runtime counts as that.
const Backend* WEFT_BACKEND_FACTORY(const char** reason) {
  using namespace WEFT_BACKEND_NS;
  int count = 0;
  const GpuError error = WEFT_GPU(GetDeviceCount)(&count);
  (void)WEFT_GPU(GetLastError)();
  if (error != gpu_success || count == 0) {
    *reason = error != gpu_success ? WEFT_GPU(GetErrorString)(error) : "no device";
    return nullptr;
  }
  static const BackendOf<GpuDevice> backend;
  static const GpuProperties properties = [] {
    GpuProperties p{};
    (void)WEFT_GPU(GetDeviceProperties)(&p, 0);
    return p;
  }();
  GpuDevice::info().device = properties.name;
  return &backend;
}

}  // namespace weft
