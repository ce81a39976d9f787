#include "bench/chapter_loop.h"

#include <cmath>

namespace weft::bench::WEFT_CHAPTER_NS {

// Corrected where the listing prints another thing than it means: sign of the force, gravity as an
// acceleration, rest lengths by n - 1, neighbour index from the offsets that the test is made for.
void chapter_step(ChapterSheet& s) {
  static constexpr int offsets[12][2] = {{1, 0},  {-1, 0},  {0, 1}, {0, -1}, {1, 1},  {1, -1},
                                         {-1, 1}, {-1, -1}, {2, 2}, {2, -2}, {-2, 2}, {-2, -2}};
  const int n = s.n;
  for (int i = 0; i < n * n; ++i) {
    const int row = i / n, column = i % n;
    const Float4 pos = s.now[size_t(i)], old = s.before[size_t(i)];
    const float vx = (pos.x - old.x) / s.dt, vy = (pos.y - old.y) / s.dt,
                vz = (pos.z - old.z) / s.dt;
    float fx = 0, fy = -9.81f * s.m, fz = 0;
    for (const auto& offset : offsets) {
      const int r = row + offset[1], c = column + offset[0];
      if (r < 0 || c < 0 || r >= n || c >= n) continue;
      const Float4 there = s.now[size_t(r * n + c)];
      const float rest =
          std::sqrt(float(offset[0] * offset[0] + offset[1] * offset[1])) / float(n - 1);
      const float dx = there.x - pos.x, dy = there.y - pos.y, dz = there.z - pos.z;
      const float length = std::sqrt(dx * dx + dy * dy + dz * dz);
      const float pull = (length - rest) * s.k / length;
      fx += dx * pull - vx * s.b;
      fy += dy * pull - vy * s.b;
      fz += dz * pull - vz * s.b;
    }
    const float h = s.dt * s.dt / s.m;
    s.next[size_t(i)] = {2 * pos.x - old.x + fx * h, 2 * pos.y - old.y + fy * h,
                         2 * pos.z - old.z + fz * h, 1};
  }
  s.before.swap(s.now);
  s.now.swap(s.next);
}

}  // namespace weft::bench::WEFT_CHAPTER_NS
