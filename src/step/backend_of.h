// A back end made of a device: the verbs of step/backend.h, written once. A Device offers
//
//   static const BackendInfo& info()
//   static Exec exec(int blocks, Workers)         executor (step/exec_contract.h)
//   static Status finish()                        waits until everything enqueued is done
//   static allocate, release, zero, to_device, to_host, copy, exclusive_scan, stable_sort_by_key
#pragma once

#include "step/backend.h"
#include "step/pipeline.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class Device>
class BackendOf final : public Backend {
 public:
  const BackendInfo& info() const noexcept override { return Device::info(); }

  void* allocate(const Allocator& host, size_t bytes) const noexcept override {
    return Device::allocate(host, bytes);
  }
  void release(const Allocator& host, void* memory, size_t bytes) const noexcept override {
    Device::release(host, memory, bytes);
  }
  Status zero(void* device, size_t bytes) const noexcept override {
    return Device::zero(device, bytes);
  }
  Status to_device(void* device, const void* host, size_t bytes) const noexcept override {
    return Device::to_device(device, host, bytes);
  }
  Status to_host(void* host, const void* device, size_t bytes) const noexcept override {
    return Device::to_host(host, device, bytes);
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
  Status probe(const Frame<float>& f, Vec3Array<float> x,
               Vec3Array<float> d) const noexcept override {
    return do_probe(f, x, d);
  }
  Status probe(const Frame<double>& f, Vec3Array<double> x,
               Vec3Array<double> d) const noexcept override {
    return do_probe(f, x, d);
  }
  Status pairs(const Frame<float>& f) const noexcept override { return do_pairs(f); }
  Status pairs(const Frame<double>& f) const noexcept override { return do_pairs(f); }
  Status survey(const Frame<float>& f) const noexcept override { return do_survey(f); }
  Status survey(const Frame<double>& f) const noexcept override { return do_survey(f); }
  Status normals(const Frame<float>& f) const noexcept override { return do_normals(f); }
  Status normals(const Frame<double>& f) const noexcept override { return do_normals(f); }
  Status write_vertices(const VertexJob<float>& job, Workers workers) const noexcept override {
    return do_write(job, workers);
  }
  Status write_vertices(const VertexJob<double>& job, Workers workers) const noexcept override {
    return do_write(job, workers);
  }
  Status shift(const OriginJob<float>& job, Workers workers) const noexcept override {
    return do_shift(job, workers);
  }
  Status shift(const OriginJob<double>& job, Workers workers) const noexcept override {
    return do_shift(job, workers);
  }
  Status copy(void* to, const void* from, size_t bytes) const noexcept override {
    return Device::copy(to, from, bytes);
  }
  Status sum(const float* device, int count, float* scratch, Workers workers,
             float& total) const noexcept override {
    return do_sum(device, count, scratch, workers, total);
  }
  Status sum(const double* device, int count, double* scratch, Workers workers,
             double& total) const noexcept override {
    return do_sum(device, count, scratch, workers, total);
  }
  Status exclusive_scan(const uint32_t* in, uint32_t* out, int count,
                        Workers workers) const noexcept override {
    return Device::exclusive_scan(in, out, count, workers);
  }
  Status stable_sort_by_key(uint32_t* keys, uint32_t* values, int count,
                            Workers workers) const noexcept override {
    return Device::stable_sort_by_key(keys, values, count, workers);
  }

 private:
  template <class T>
  static auto exec(const Frame<T>& f) {
    return Device::exec(blocks_to_share(f.sim), f.workers);
  }
  template <class T>
  static Status do_frame(Frame<T>& f) {
    auto e = exec(f);
    run_frame(e, f);
    return Device::finish();
  }
  template <class T>
  static Status do_start(Frame<T>& f) {
    auto e = exec(f);
    run_start(e, f);
    return Device::finish();
  }
  template <class T>
  static Status do_accelerations(const Frame<T>& f) {
    auto e = exec(f);
    run_accelerations(e, f);
    return Device::finish();
  }
  template <class T>
  static Status do_probe(const Frame<T>& f, Vec3Array<T> x, Vec3Array<T> d) {
    auto e = exec(f);
    run_probe(e, f, x, d);
    return Device::finish();
  }
  template <class T>
  static Status do_pairs(const Frame<T>& f) {
    auto e = exec(f);
    run_pairs(e, f);
    return Device::finish();
  }
  template <class T>
  static Status do_survey(const Frame<T>& f) {
    auto e = exec(f);
    run_survey(e, f);
    return Device::finish();
  }
  template <class T>
  static Status do_normals(const Frame<T>& f) {
    auto e = exec(f);
    run_normals(e, f);
    return Device::finish();
  }
  template <class T>
  static Status do_write(const VertexJob<T>& job, Workers workers) {
    auto e = Device::exec((job.vertices + block_size - 1) / block_size, workers);
    run_write_vertices(e, job);
    return Device::finish();
  }
  template <class T>
  static Status do_shift(const OriginJob<T>& job, Workers workers) {
    auto e = Device::exec((job.particles + block_size - 1) / block_size, workers);
    run_shift(e, job);
    return Device::finish();
  }
  template <class T>
  static Status do_sum(const T* device, int count, T* scratch, Workers workers, T& total) {
    auto e = Device::exec(count / block_size, workers);
    const T* result = run_sum(e, device, count, scratch);
    return Device::to_host(&total, result, sizeof total);
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
