// Sums over the triangles around a particle, in their own sense of rotation and a fixed order.
//
// `sum_triangles(..., read, share, sum)`: read(i) loads what a corner brings along, share(here,
// next, last) is what the triangle of three such corners does to the first; the shares are added to
// `sum`, a LaneVec3 or what else keeps one share per lane. Where a triangle is missing, all corners
// are the particle itself: no area.
#pragma once

#include "base/lanes.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Position and displacement of the last substep.
template <class T>
struct Corner {
  Vec3<T> x, d;
};
template <class T>
WEFT_HD Corner<T> select(bool condition, Corner<T> yes, Corner<T> no) {
  return {select(condition, yes.x, no.x), select(condition, yes.d, no.d)};
}

/// A grid's quads are split along (1,1), so that six triangles meet in a vertex:
///
///           N --- NE
///         / |   / |       next, last = E,NE  NE,N  N,W  W,SW  SW,S  S,E
///       W - i --- E       columns run to E, rows to N
///       | / |   /
///      SW - S           NE is there when N and E are, SW when S and W are
template <class T>
struct GridFan {
  const uint16_t* presence;
  const uint8_t* inner;

  template <int N, class Read, class Share, class Sum>
  WEFT_HD void sum_triangles(const ClothParams<T>& cloth, int block, int i0, Lanes<N> lanes,
                             Read read, Share share, Sum& sum) const {
    if (inner[block]) {
      sum_six<true>(cloth, i0, lanes, read, share, sum);
    } else {
      sum_six<false>(cloth, i0, lanes, read, share, sum);
    }
  }

 private:
  template <bool Inner, int N, class Read, class Share, class Sum>
  WEFT_HD void sum_six(const ClothParams<T>& cloth, int i0, Lanes<N> lanes, Read read, Share share,
                       Sum& sum) const {
    const int e = cloth.axial[0], n = cloth.axial[1], w = cloth.axial[2], s = cloth.axial[3];
    const int column = cloth.columns;
    const uint16_t* of = presence;
    lanes.each([&](int l) WEFT_LANE {
      const int i = i0 + l, bits = Inner ? 0 : of[i];
      const auto here = read(i);
      const auto corner = [&](int shift, int needs) WEFT_LANE {
        const auto there = read(i + shift);
        if constexpr (Inner) {
          return there;
        } else {
          return select((bits & needs) == needs, there, here);
        }
      };
      const auto east = corner(1, e), north_east = corner(column + 1, n | e);
      const auto north = corner(column, n), west = corner(-1, w);
      const auto south_west = corner(-column - 1, s | w), south = corner(-column, s);
      // Both corners of a triangle must be there; one that is not stands for no area.
      auto all = share(here, east, north_east);
      all = all + share(here, north_east, north);
      all = all + share(here, north, west);
      all = all + share(here, west, south_west);
      all = all + share(here, south_west, south);
      all = all + share(here, south, east);
      sum.set(l, all);
    });
  }
};

template <class T>
struct MeshFan {
  TriangleRows rows;

  template <int N, class Read, class Share, class Sum>
  WEFT_HD void sum_triangles(const ClothParams<T>&, int block, int i0, Lanes<N> lanes, Read read,
                             Share share, Sum& sum) const {
    lanes.each([&](int l) WEFT_LANE { sum.set(l, {}); });
    if (rows.start == nullptr) return;  // networks only
    const int slice = block - rows.first_block;
    const int32_t *next = rows.next, *last = rows.last;
    for (int64_t t = rows.start[slice] + (i0 - block * block_size); t < rows.start[slice + 1];
         t += block_size) {
      lanes.each([&](int l) WEFT_LANE {
        sum.set(l, sum.get(l) + share(read(i0 + l), read(next[t + l]), read(last[t + l])));
      });
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
