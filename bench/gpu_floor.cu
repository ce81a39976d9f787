// The floor of a step on the GPU: how fast its memory copies.
#include <cuda_runtime.h>

#include <algorithm>

namespace weft::bench {

double gpu_copy_bandwidth() {
  constexpr size_t bytes = size_t(512) << 20;
  void *from = nullptr, *to = nullptr;
  cudaEvent_t begin{}, end{};
  bool good = cudaMalloc(&from, bytes) == cudaSuccess && cudaMalloc(&to, bytes) == cudaSuccess &&
              cudaEventCreate(&begin) == cudaSuccess && cudaEventCreate(&end) == cudaSuccess;
  float least = 0;
  for (int i = 0; good && i < 11; ++i) {
    float ms = 0;
    good = cudaEventRecord(begin) == cudaSuccess &&
           cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice) == cudaSuccess &&
           cudaEventRecord(end) == cudaSuccess && cudaEventSynchronize(end) == cudaSuccess &&
           cudaEventElapsedTime(&ms, begin, end) == cudaSuccess;
    if (i == 1) least = ms;  // the first is a warm-up
    if (i > 1) least = std::min(least, ms);
  }
  if (begin) (void)cudaEventDestroy(begin);
  if (end) (void)cudaEventDestroy(end);
  (void)cudaFree(from);
  (void)cudaFree(to);
  (void)cudaGetLastError();
  return good && least > 0 ? 2.0 * double(bytes) / (double(least) * 1e-3) : 0;
}

}  // namespace weft::bench
