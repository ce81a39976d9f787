// A race on purpose: two threads of the executor read what the other writes, and meet only when the
// program is called with an argument. Shows that the thread sanitizer would find a missing barrier.
#include "omp/exec.h"

#include <utility>
#include <vector>

namespace {

struct AverageNeighbours {
  const float* in;
  float* out;
  int count;

  template <int N>
  void operator()(int block, int lane0, weft::WEFT_BACKEND_NS::Lanes<N> lanes) const {
    lanes.each([&](int l) WEFT_LANE {
      const int i = block * weft::block_size + lane0 + l;
      out[i] = 0.5f * (in[(i + 1) % count] + in[(i + count - 1) % count]);
    });
  }
};

}  // namespace

int main(int argc, char**) {
  constexpr int blocks = 256;
  std::vector<float> a(blocks * weft::block_size, 1.0f);
  std::vector<float> b(a.size());
  const weft::WEFT_BACKEND_NS::Exec exec(1000, 2);  // blocks enough for both threads
  exec.frame([&](const auto& team) {
    float* in = a.data();
    float* out = b.data();
    for (int pass = 0; pass < 100; ++pass) {
      team.for_each_block(blocks, AverageNeighbours{in, out, blocks * weft::block_size});
      if (argc > 1) team.meet();
      std::swap(in, out);
    }
  });
  return a[0] == 1.0f ? 0 : 1;
}
