// The OpenMP executor: blocks are split evenly over threads in order, 32 lanes a block, one
// parallel region per frame. Part of every instruction-level object: no container, no algorithm, no
// stream.
#pragma once

#include <omp.h>
#include <sched.h>

#include "base/atomic.h"
#include "base/lanes.h"
#include "step/exec_contract.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Meeting point of the threads of one region. Spins for a while, since substeps are short, then
/// yields, so that more threads than cores still make progress.
class Barrier {
 public:
  void wait(int threads) {
    const int round = atomic_load(&round_);
    if (atomic_add(&arrived_, 1) == threads) {
      atomic_store(&arrived_, 0);
      atomic_store(&round_, round + 1);
      return;
    }
    int spins = 0;
    while (atomic_load(&round_) == round) {
      if (++spins > 4000) sched_yield();
    }
  }

 private:
  alignas(64) int arrived_ = 0;
  alignas(64) int round_ = 0;
};

/// What one thread of a region sees.
class Team {
 public:
  static constexpr bool fuses = WEFT_FUSE_PASSES;

  Team(int thread, int threads, Barrier* barrier)
      : thread_(thread), threads_(threads), barrier_(barrier) {}

  template <class Kernel>
  __attribute__((noinline)) void for_each_block(int count, const Kernel& shared) const {
    check_kernel<Kernel>();
    const Kernel kernel = shared;  // a copy of this thread's own: nothing can alias its members
    const int begin = static_cast<int>(int64_t(count) * thread_ / threads_);
    const int end = static_cast<int>(int64_t(count) * (thread_ + 1) / threads_);
    for (int block = begin; block < end; ++block) kernel(block, 0, Lanes<block_size>{});
  }
  void meet() const {
    if (threads_ > 1) barrier_->wait(threads_);
  }
  /// One thread of the team, for what must be done once.
  bool leads() const { return thread_ == 0; }

 private:
  int thread_, threads_;
  Barrier* barrier_;
};

class Exec {
 public:
  explicit Exec(int threads) : threads_(threads) {}

  /// Threads worth using: a second one pays from about 1000 particles.
  static int useful_threads(int blocks, int wanted) {
    const int most = blocks / 16 > 1 ? blocks / 16 : 1;
    return wanted < most ? wanted : most;
  }

  template <class Body>
  void frame(const Body& body) const {
    if (threads_ <= 1) return body(Team(0, 1, nullptr));
    Barrier barrier;
#pragma omp parallel num_threads(threads_)
    body(Team(omp_get_thread_num(), omp_get_num_threads(), &barrier));
  }

 private:
  int threads_;
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
