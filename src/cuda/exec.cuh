// The GPU executor: a warp is a block, eight warps a thread block; everything goes to one stream,
// whose order is the barrier.
#pragma once

#include "cuda/gpu_api.h"  // first: what it declares is called in templates below

#include "base/lanes.h"
#include "cuda/sort.h"
#include "step/exec_contract.h"
#include "step/stage_clock.h"

namespace weft {
namespace WEFT_BACKEND_NS {

constexpr int warps_per_group = 8;

template <class Kernel>
__global__ void run_blocks(const int count, WEFT_LAUNCH_CONSTANT const Kernel kernel) {
  const int block =
      static_cast<int>(blockIdx.x) * warps_per_group + static_cast<int>(threadIdx.x) / block_size;
  if (block < count) kernel(block, static_cast<int>(threadIdx.x) % block_size, Lanes<1>{});
}

/// What the host sees of the device: launches return before they are done.
class Team {
 public:
  static constexpr bool fuses = false;
  static constexpr bool sees = false;

  explicit Team(GpuStream stream) : stream_(stream) {}

  template <class Kernel>
  void for_each_block(int count, const Kernel& kernel) const {
    check_kernel<Kernel>();
    if (count == 0) return;
    const int groups = (count + warps_per_group - 1) / warps_per_group;
    run_blocks<<<dim3(static_cast<unsigned>(groups)), dim3(warps_per_group * block_size), 0,
                 stream_>>>(count, kernel);
  }
  void sort_by_key(uint32_t* keys, uint32_t* values, int count, int, SortRoom room) const {
    enqueue_sort(keys, values, count, 32, room.words, room.count, stream_);
  }
  void sort_few_bits(uint32_t* keys, uint32_t* values, int count, int bits, SortRoom room) const {
    enqueue_sort(keys, values, count, bits, room.words, room.count, stream_);
  }
  void meet() const {}
  // The host enqueues and does not wait: it cannot say how long a part of the frame takes.
  void lap(Lap) const {}
  void start_clock() const {}
  bool leads() const { return true; }

 private:
  GpuStream stream_;
};

class Exec {
 public:
  explicit Exec(GpuStream stream) : stream_(stream) {}

  template <class Body>
  void frame(const Body& body) const {
    body(Team(stream_));
  }

 private:
  GpuStream stream_;
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
