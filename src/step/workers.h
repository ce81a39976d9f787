// Who does the work of a verb.
#pragma once

#include "step/stage_clock.h"
#include "weft/core.hpp"

namespace weft {

/// A second thread pays from about 1000 particles.
constexpr int blocks_a_thread = 16;

struct Workers {
  int threads;                  ///< most that the host back end may use
  const Jobs* jobs = nullptr;   ///< the caller's; null: the back end's own
  StageClock* clock = nullptr;  ///< null: nobody asks how long the parts of a frame take
  /// To which the CPU time of the threads is added, s; of the whole process where the caller brings
  /// jobs. Null: nobody asks.
  double* cpu_seconds = nullptr;

  constexpr Workers(int threads_at_most, const Jobs* of_caller = nullptr)
      : threads(threads_at_most), jobs(of_caller) {}
};

}  // namespace weft
