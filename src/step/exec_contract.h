// What an executor offers to step/pipeline.h. omp/exec.h and cuda/exec.cuh keep to it.
//
//   Exec exec;
//   exec.frame(body)                     runs body(team) with everything inside enqueued together:
//                                        one parallel region on the CPU, whose threads all run the
//                                        body; one stream on the GPU, where the host runs it once
//   team.for_each_block(count, kernel)   kernel(block, lane, lanes) for every block below count;
//                                        the kernel is a trivially copyable functor; returns before
//                                        the other threads are done
//   team.sort_by_key(keys, values, count, turn, room)
//   team.sort_few_bits(keys, values, count, bits, room)
//                                        stable; whoever needs the order meets first
//   team.meet()                          everything before is visible to everything after
//   team.lap(Lap)                        after a meeting: the time since the last lap was for this
//                                        part of the frame (step/stage_clock.h); begins with
//                                        team.start_clock()
//   Team::sees                           within a frame the threads may read, after a meeting, what
//                                        kernels have written: not where the host only enqueues
//   Team::fuses                          a substep is one pass (step/variants.h), since what it has
//                                        just written is still in a cache
//
// Built on these: reduce (step/reduce.h), a fixed tree whose bits no thread count changes. Outside
// a frame: exclusive_scan and stable_sort_by_key (step/backend.h). Sorts and scans are each in a
// translation unit apart from the kernels.
#pragma once

#include <type_traits>

#include "base/portability.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Device memory for a sort within a frame, which takes none of its own.
struct SortRoom {
  uint32_t* words;
  int64_t count;  ///< twice what is sorted at least, and some more for a GPU
};

/// A kernel whose blocks differ in length says so by `uneven`, and by work_before(block),
/// ascending, what those before one take: a host shares them out by it.
template <class Kernel, class = void>
struct is_uneven : std::false_type {};
template <class Kernel>
struct is_uneven<Kernel, std::enable_if_t<Kernel::uneven>> : std::true_type {};

template <class Kernel>
constexpr void check_kernel() {
  static_assert(std::is_trivially_copyable_v<Kernel>,
                "a kernel is copied to the device byte by byte: views and scalars only");
  static_assert(sizeof(Kernel) <= 4000, "a kernel's arguments must fit a launch (4 kB)");
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
