// The host back end at one instruction level. CMake compiles this file once per level, each in a
// namespace of its own (WEFT_BACKEND_NS); the registry picks one at start-up.
#include "omp/exec.h"
#include "omp/interop.h"
#include "omp/memory.h"
#include "omp/sort.h"
#include "step/backend_of.h"

namespace weft {
namespace WEFT_BACKEND_NS {

struct HostDevice {
  static const BackendInfo& info() {
    // "omp_v4": the level begins behind the underscore.
    static const BackendInfo info{"omp", "host processor", &WEFT_BACKEND_NAME[4],
                                  WEFT_VECTOR_STRIDE, true};
    return info;
  }
  static Exec exec(int blocks, Workers workers) { return Exec(blocks, workers); }
  static Status finish() { return Status::ok; }

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
    return copy_to_host(to, from, bytes);
  }
  static Status exclusive_scan(const uint32_t* in, uint32_t* out, int count, Workers workers) {
    omp::exclusive_scan(in, out, count, workers.jobs != nullptr);
    return Status::ok;
  }
  static Status stable_sort_by_key(uint32_t* keys, uint32_t* values, int count, Workers workers) {
    omp::stable_sort_by_key(keys, values, count, workers.jobs != nullptr);
    return Status::ok;
  }
};

}  // namespace WEFT_BACKEND_NS

const Backend& WEFT_BACKEND_FACTORY() {
  static const WEFT_BACKEND_NS::BackendOf<WEFT_BACKEND_NS::HostDevice> backend;
  return backend;
}

}  // namespace weft
