// The CPU loop of Fratarcangeli 2011, Listing 22.1, as it means it: array of float4, one thread.
// Built twice from one source: with plain -O3, and with the flags that weft's own kernels use.
#pragma once

#include <vector>

namespace weft::bench {

struct Float4 {
  float x, y, z, w;
};

struct ChapterSheet {
  int n = 0;
  float k = 0, m = 0, b = 0, dt = 0;
  std::vector<Float4> now, before, next;
};

/// n x n vertices over the unit square, at rest.
ChapterSheet make_chapter_sheet(int n, float k, float m, float dt);

namespace plain {
void chapter_step(ChapterSheet&);
}
namespace bit_safe {
void chapter_step(ChapterSheet&);
}
namespace bit_safe_v4 {
void chapter_step(ChapterSheet&);
}

}  // namespace weft::bench
