// The door between the host side and a back end: memory, and a handful of verbs.
#pragma once

#include "state/scratch.h"
#include "state/vertices.h"
#include "step/frame.h"
#include "weft/core.hpp"

namespace weft {

struct BackendInfo {
  const char* name;    ///< "omp", "cuda", "hip"
  const char* device;  ///< name of the processor or GPU
  const char* isa;     ///< level of the host kernels; "-" on a GPU
  int vector_stride;   ///< memory layout of vectors: base/portability.h
  bool host_memory;    ///< device memory can be read and written by the host
};

/// One compiled copy of the kernels with the device it runs on. Stateless: may be used from several
/// threads with different simulations. A failing verb returns device_lost or out_of_memory.
class Backend {
 public:
  virtual ~Backend();  // defined in backend.cpp, so that the class has one home among the objects

  virtual const BackendInfo& info() const noexcept = 0;

  /// Device memory, aligned to 128 bytes; host back ends take it from `host`. Null: out of memory.
  virtual void* allocate(const Allocator& host, size_t bytes) const noexcept = 0;
  virtual void release(const Allocator& host, void* memory, size_t bytes) const noexcept = 0;
  virtual Status zero(void* device, size_t bytes) const noexcept = 0;
  virtual Status to_device(void* device, const void* host, size_t bytes) const noexcept = 0;
  virtual Status to_host(void* host, const void* device, size_t bytes) const noexcept = 0;

  virtual Status frame(Frame<float>&) const noexcept = 0;
  virtual Status frame(Frame<double>&) const noexcept = 0;
  virtual Status start(Frame<float>&) const noexcept = 0;
  virtual Status start(Frame<double>&) const noexcept = 0;
  virtual Status accelerations(const Frame<float>&) const noexcept = 0;
  virtual Status accelerations(const Frame<double>&) const noexcept = 0;
  /// A substep into `x` and `d`, which no state is kept in: the present stays as it is.
  virtual Status probe(const Frame<float>&, Vec3Array<float> x,
                       Vec3Array<float> d) const noexcept = 0;
  virtual Status probe(const Frame<double>&, Vec3Array<double> x,
                       Vec3Array<double> d) const noexcept = 0;
  /// Pairs near each other now, into the rows of Contacts.
  virtual Status pairs(const Frame<float>&) const noexcept = 0;
  virtual Status pairs(const Frame<double>&) const noexcept = 0;
  /// What run_frame leaves behind, for state that no frame has made.
  virtual Status survey(const Frame<float>&) const noexcept = 0;
  virtual Status survey(const Frame<double>&) const noexcept = 0;
  /// Unit normals into x[1].
  virtual Status normals(const Frame<float>&) const noexcept = 0;
  virtual Status normals(const Frame<double>&) const noexcept = 0;

  /// Vertices into memory that the back end can reach: on the host, the caller's buffer.
  virtual Status write_vertices(const VertexJob<float>&, Workers) const noexcept = 0;
  virtual Status write_vertices(const VertexJob<double>&, Workers) const noexcept = 0;
  /// Positions in device memory, to another origin.
  virtual Status shift(const OriginJob<float>&, Workers) const noexcept = 0;
  virtual Status shift(const OriginJob<double>&, Workers) const noexcept = 0;
  /// Within device memory.
  virtual Status copy(void* to, const void* from, size_t bytes) const noexcept = 0;

  /// Sum over the fixed tree of step/reduce.h, of device memory into scratch[...]; the sum comes
  /// back.
  virtual Status sum(const float* device, int count, float* scratch, Workers,
                     float& total) const noexcept = 0;
  virtual Status sum(const double* device, int count, double* scratch, Workers,
                     double& total) const noexcept = 0;
  /// out[i] = sum of in[0, i); in and out may be the same.
  virtual Status exclusive_scan(const uint32_t* in, uint32_t* out, int count,
                                Workers) const noexcept = 0;
  /// Sorts pairs by key; equal keys keep their order.
  virtual Status stable_sort_by_key(uint32_t* keys, uint32_t* values, int count,
                                    Workers) const noexcept = 0;
};

}  // namespace weft
