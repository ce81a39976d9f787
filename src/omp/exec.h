// The OpenMP executor: blocks are split evenly over threads in order, by number or by work, 32
// lanes a block, one parallel region per frame. Part of every instruction-level object: no
// container, no algorithm, no stream.
#pragma once

#include <omp.h>
#if defined(__linux__)
#  include <linux/futex.h>
#  include <sys/syscall.h>
#  include <unistd.h>
#else
#  include <sched.h>
#endif
#include <time.h>

#include "base/atomic.h"
#include "base/lanes.h"
#include "omp/sort.h"
#include "step/exec_contract.h"
#include "step/stage_clock.h"
#include "step/workers.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Meeting point of the threads of one region. Spins briefly, since substeps are short, then
/// sleeps: on a busy machine who spins takes the time of the thread that it waits for. Who has
/// slept once spins less the next time.
class Barrier {
 public:
  void wait(int threads) {
    const int round = atomic_load(&round_);
    if (atomic_add(&arrived_, 1) == threads) {
      atomic_store(&arrived_, 0);
      // Either this thread sees that one sleeps, or that one sees the new round.
      __atomic_store_n(&round_, round + 1, __ATOMIC_SEQ_CST);
      if (__atomic_load_n(&sleepers_, __ATOMIC_SEQ_CST) > 0) wake_all(&round_);
      return;
    }
    const int most = __atomic_load_n(&spins_, __ATOMIC_RELAXED);
    for (int spins = 0; spins < most; ++spins) {
      if (atomic_load(&round_) != round) return spin(most + most / 8);
      pause();
    }
    spin(most / 2);
    __atomic_add_fetch(&sleepers_, 1, __ATOMIC_SEQ_CST);
    while (atomic_load(&round_) == round) sleep_while(&round_, round);
    __atomic_sub_fetch(&sleepers_, 1, __ATOMIC_SEQ_CST);
  }

 private:
  // A sleep and a waking take some 10 us; a round of the loop some 20 to 40 ns.
  static constexpr int most_spins = 2000, least_spins = 64;

  void spin(int next_time) {
    const int most = next_time < most_spins ? next_time : most_spins;
    __atomic_store_n(&spins_, most > least_spins ? most : least_spins, __ATOMIC_RELAXED);
  }
  static void pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  static void sleep_while(int* word, int value) {
#if defined(__linux__)
    syscall(SYS_futex, word, FUTEX_WAIT_PRIVATE, value, nullptr, nullptr, 0);
#else
    sched_yield();
#endif
  }
  static void wake_all(int* word) {
#if defined(__linux__)
    syscall(SYS_futex, word, FUTEX_WAKE_PRIVATE, 1 << 30, nullptr, nullptr, 0);
#endif
  }

  alignas(64) int arrived_ = 0;
  alignas(64) int round_ = 0;
  int sleepers_ = 0;
  alignas(64) int spins_ = most_spins;
};

/// CPU time of this thread, or of the process, s.
inline double cpu_seconds(clockid_t of) {
  timespec now{};
  clock_gettime(of, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The blocks [begin, end) of a kernel: what a thread of either kind runs.
template <class Kernel>
__attribute__((noinline)) void run_range(const Kernel& shared, int begin, int end) {
  const Kernel kernel = shared;  // a copy of this thread's own: nothing can alias its members
  for (int block = begin; block < end; ++block) kernel(block, 0, Lanes<block_size>{});
}

/// The block at which thread `thread` of `threads` begins: shares are equal in number or, where the
/// kernel's blocks are uneven, in work.
template <class Kernel>
int first_of_share(const Kernel& kernel, int count, int thread, int threads) {
  if constexpr (is_uneven<Kernel>::value) {
    const int64_t wanted = kernel.work_before(count) * thread / threads;
    int low = 0, high = count;
    while (low < high) {
      const int middle = low + (high - low) / 2;
      if (kernel.work_before(middle) < wanted) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  } else {
    return static_cast<int>(int64_t(count) * thread / threads);
  }
}

/// What one thread of a region sees; where the caller brings jobs, its own thread.
class Team {
 public:
  static constexpr bool fuses = WEFT_FUSE_PASSES;
  static constexpr bool sees = WEFT_FUSE_PASSES;

  Team(int thread, int threads, Barrier* barrier, StageClock* clock)
      : thread_(thread), threads_(threads), barrier_(barrier), clock_(clock) {}
  Team(const Jobs& jobs, StageClock* clock) : clock_(clock), jobs_(&jobs) {}

  template <class Kernel>
  void for_each_block(int count, const Kernel& kernel) const {
    check_kernel<Kernel>();
    if (jobs_ != nullptr) return hand_out(count, kernel);
    if (threads_ == 1) return run_range(kernel, 0, count);
    const int begin = first_of_share(kernel, count, thread_, threads_);
    const int end =
        thread_ + 1 == threads_ ? count : first_of_share(kernel, count, thread_ + 1, threads_);
    run_range(kernel, begin, end);
  }
  /// Sorts pairs by key, equal keys in their order: every call one thread, the calls of a pass by
  /// turns. Whoever needs the order meets first.
  void sort_by_key(uint32_t* keys, uint32_t* values, int count, int turn, SortRoom) const {
    if (turn % threads_ == thread_) omp::stable_sort_by_key(keys, values, count, true);
  }
  /// Sorts 0, 1, 2, ... by keys below 2^bits.
  void sort_few_bits(uint32_t* keys, uint32_t* values, int count, int bits, SortRoom room) const {
    uint32_t* const counts = room.words + count;
    const omp::CellSort sort{keys, nullptr, values, keys, nullptr, room.words, counts, count, bits};
    const size_t words = static_cast<size_t>(count), bytes = words * sizeof(uint32_t);
    if (!omp::sorts_without_starts(count, bits) || omp::room_of_cell_sort(sort) > bytes) {
      if (leads()) omp::stable_sort_by_key(keys, values, count, true);
      return;
    }
    const bool together = omp::cell_sort_counts(count, bits, threads_) <= words;
    const int threads = together ? threads_ : 1;
    const bool takes_part = thread_ < threads;
    if (takes_part) omp::count_cells(sort, thread_, threads);
    meet();
    if (takes_part) omp::deal_cells(sort, thread_, threads);
    meet();
    if (takes_part) omp::place_cells(sort, thread_, threads);
  }
  void meet() const {
    if (threads_ > 1) barrier_->wait(threads_);
  }
  /// After a meeting: what has passed since the last lap belongs to this part of the frame.
  void lap(Lap of) const {
    if (clock_ == nullptr || !leads()) return;
    const double now = omp_get_wtime();
    clock_->seconds[static_cast<int>(of)] += now - clock_->last;
    clock_->last = now;
  }
  void start_clock() const {
    if (clock_ != nullptr && leads()) clock_->last = omp_get_wtime();
  }
  /// One thread of the team, for what must be done once.
  bool leads() const { return thread_ == 0; }
  int threads() const { return jobs_ != nullptr ? static_cast<int>(jobs_->workers) : threads_; }

 private:
  /// A dispatch costs microseconds: fewer than 16 blocks are not worth one.
  template <class Kernel>
  void hand_out(int count, const Kernel& kernel) const {
    if (count < 16) return run_range(kernel, 0, count);
    const int share = count / (4 * static_cast<int>(jobs_->workers));
    const auto run = [](void* context, uint32_t begin, uint32_t end) {
      run_range(*static_cast<const Kernel*>(context), static_cast<int>(begin),
                static_cast<int>(end));
    };
    jobs_->parallel_for(jobs_->user, static_cast<uint32_t>(count),
                        static_cast<uint32_t>(share > 8 ? share : 8), run,
                        const_cast<Kernel*>(&kernel), "weft");
  }

  int thread_ = 0, threads_ = 1;
  Barrier* barrier_ = nullptr;
  StageClock* clock_ = nullptr;
  const Jobs* jobs_ = nullptr;
};

class Exec {
 public:
  Exec(int blocks, Workers workers)
      : threads_(useful_threads(blocks, workers.threads)),
        jobs_(workers.jobs),
        clock_(workers.clock),
        cpu_(workers.cpu_seconds) {}

  template <class Body>
  void frame(const Body& body) const {
    double cpu = 0;
    if (jobs_ != nullptr) {
      cpu = timed(CLOCK_PROCESS_CPUTIME_ID, body, Team(*jobs_, clock_));
    } else if (threads_ <= 1) {
      cpu = timed(CLOCK_THREAD_CPUTIME_ID, body, Team(0, 1, nullptr, clock_));
    } else {
      Barrier barrier;
#pragma omp parallel num_threads(threads_) reduction(+ : cpu)
      {
        const Team team(omp_get_thread_num(), omp_get_num_threads(), &barrier, clock_);
        cpu += timed(CLOCK_THREAD_CPUTIME_ID, body, team);
        team.meet();  // OpenMP's own barrier spins for long
      }
    }
    if (cpu_) *cpu_ += cpu;
  }

 private:
  /// CPU time that the body has taken, if anyone asks.
  template <class Body>
  double timed(clockid_t of, const Body& body, const Team& team) const {
    const double begin = cpu_ ? cpu_seconds(of) : 0;
    body(team);
    return cpu_ ? cpu_seconds(of) - begin : 0;
  }

  static int useful_threads(int blocks, int wanted) {
    const int most = blocks / blocks_a_thread > 1 ? blocks / blocks_a_thread : 1;
    return wanted < most ? wanted : most;
  }

  int threads_;
  const Jobs* jobs_;
  StageClock* clock_;
  double* cpu_;
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
