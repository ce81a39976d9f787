// The host back end at one instruction level. CMake compiles this file once per level, each in a
// namespace of its own (WEFT_BACKEND_NS); the registry picks one at start-up.
#include "step/backend.h"

#include "omp/exec.h"
#include "omp/interop.h"
#include "omp/memory.h"
#include "omp/sort.h"
#include "step/pipeline.h"

namespace weft {
namespace WEFT_BACKEND_NS {

class HostBackend final : public Backend {
 public:
  const BackendInfo& info() const noexcept override { return info_; }

  void* allocate(const Allocator& host, size_t bytes) const noexcept override {
    return allocate_memory(host, bytes);
  }
  void release(const Allocator& host, void* memory, size_t bytes) const noexcept override {
    release_memory(host, memory, bytes);
  }
  Status zero(void* device, size_t bytes) const noexcept override {
    return zero_device(device, bytes);
  }
  Status to_device(void* device, const void* host, size_t bytes) const noexcept override {
    return copy_to_device(device, host, bytes);
  }
  Status to_host(void* host, const void* device, size_t bytes) const noexcept override {
    return copy_to_host(host, device, bytes);
  }

  Status frame(Frame<float>& f) const noexcept override { return do_frame(f); }
  Status frame(Frame<double>& f) const noexcept override { return do_frame(f); }
  Status start(Frame<float>& f) const noexcept override { return do_start(f); }
  Status start(Frame<double>& f) const noexcept override { return do_start(f); }
  Status accelerations(const Frame<float>& f) const noexcept override {
    return do_accelerations(f);
  }
  Status accelerations(const Frame<double>& f) const noexcept override {
    return do_accelerations(f);
  }
  Status count_not_finite(const Frame<float>& f, int32_t* scratch,
                          int32_t& count) const noexcept override {
    return do_count(f, scratch, count);
  }
  Status count_not_finite(const Frame<double>& f, int32_t* scratch,
                          int32_t& count) const noexcept override {
    return do_count(f, scratch, count);
  }
  Status sum(const float* device, int count, float* scratch, int threads,
             float& total) const noexcept override {
    return do_sum(device, count, scratch, threads, total);
  }
  Status sum(const double* device, int count, double* scratch, int threads,
             double& total) const noexcept override {
    return do_sum(device, count, scratch, threads, total);
  }
  Status exclusive_scan(const uint32_t* in, uint32_t* out, int count) const noexcept override {
    omp::exclusive_scan(in, out, count);
    return Status::ok;
  }
  Status stable_sort_by_key(uint32_t* keys, uint32_t* values, int count) const noexcept override {
    omp::stable_sort_by_key(keys, values, count);
    return Status::ok;
  }

 private:
  template <class T>
  static Exec exec(const Frame<T>& f) {
    return Exec(Exec::useful_threads(f.sim.blocks, f.threads));
  }
  template <class T>
  static Status do_frame(Frame<T>& f) {
    Exec e = exec(f);
    run_frame(e, f);
    return Status::ok;
  }
  template <class T>
  static Status do_start(Frame<T>& f) {
    Exec e = exec(f);
    run_start(e, f);
    return Status::ok;
  }
  template <class T>
  static Status do_accelerations(const Frame<T>& f) {
    Exec e = exec(f);
    run_accelerations(e, f);
    return Status::ok;
  }
  template <class T>
  static Status do_count(const Frame<T>& f, int32_t* scratch, int32_t& count) {
    Exec e = exec(f);
    count = *run_count_not_finite(e, f, scratch);
    return Status::ok;
  }
  template <class T>
  static Status do_sum(const T* device, int count, T* scratch, int threads, T& total) {
    Exec e(Exec::useful_threads(count / block_size, threads));
    const T* result = nullptr;
    e.frame([&](const auto& team) {
      const T* sum = reduce(team, ElementOf<T>{device}, count, scratch);
      if (team.leads()) result = sum;
    });
    total = *result;
    return Status::ok;
  }

  static constexpr const char* level() {
    // "omp_v4" -> "v4"
    constexpr const char* name = WEFT_BACKEND_NAME;
    return name + 4;
  }
  BackendInfo info_{"omp", "host processor", level(), WEFT_PARTICLE_STEP, true};
};

}  // namespace WEFT_BACKEND_NS

const Backend& WEFT_BACKEND_FACTORY() {
  static const WEFT_BACKEND_NS::HostBackend backend;
  return backend;
}

}  // namespace weft
