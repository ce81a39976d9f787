// The floor of a step on the GPU: how fast its memory copies. Part of the benchmarks, not of the
// library.
#include <algorithm>

#include "cuda/gpu_api.h"

namespace weft::bench {

double gpu_copy_bandwidth() {
  using namespace WEFT_BACKEND_NS;
  constexpr size_t bytes = size_t(512) << 20;
  void *from = nullptr, *to = nullptr;
  WEFT_GPU(Event_t) begin{}, end{};
  bool good = WEFT_GPU(Malloc)(&from, bytes) == gpu_success &&
              WEFT_GPU(Malloc)(&to, bytes) == gpu_success &&
              WEFT_GPU(EventCreate)(&begin) == gpu_success &&
              WEFT_GPU(EventCreate)(&end) == gpu_success;
  float least = 0;
  for (int i = 0; good && i < 11; ++i) {
    float ms = 0;
    good = WEFT_GPU(EventRecord)(begin, nullptr) == gpu_success &&
           WEFT_GPU(MemcpyAsync)(to, from, bytes, WEFT_GPU(MemcpyDeviceToDevice), nullptr) ==
               gpu_success &&
           WEFT_GPU(EventRecord)(end, nullptr) == gpu_success &&
           WEFT_GPU(EventSynchronize)(end) == gpu_success &&
           WEFT_GPU(EventElapsedTime)(&ms, begin, end) == gpu_success;
    if (i == 1) least = ms;  // the first is a warm-up
    if (i > 1) least = std::min(least, ms);
  }
  if (begin) (void)WEFT_GPU(EventDestroy)(begin);
  if (end) (void)WEFT_GPU(EventDestroy)(end);
  (void)WEFT_GPU(Free)(from);
  (void)WEFT_GPU(Free)(to);
  (void)WEFT_GPU(GetLastError)();
  return good && least > 0 ? 2.0 * double(bytes) / (double(least) * 1e-3) : 0;
}

}  // namespace weft::bench
