// Unit normals of the vertices, weighted by the areas of their triangles.
#pragma once

#include "kernels/fan.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Zero where there is no area, finite everywhere (hard case 7), and zero where the areas cancel to
/// what rounding leaves of their sum without signs, `size`.
template <class T>
WEFT_HD Vec3<T> unit_or_zero(Vec3<T> v, T size) {
  constexpr T rounding = sizeof(T) == 4 ? T(2e-6) : T(4e-15);
  const T per_size = T(1) / (size > T(1e-37) ? size : T(1));  // squares of small areas would vanish
  const Vec3<T> u = per_size * v;
  const T length = square_root(dot(u, u));
  const bool has_length = length > rounding;
  const T scale = T(1) / (has_length ? length : T(1));
  return select(has_length, scale * u, Vec3<T>{T(0), T(0), T(0)});
}

/// N = 2 A n of triangles, and what they would be without signs.
template <class T>
struct Area {
  Vec3<T> vector;
  T size;
};
template <class T>
WEFT_HD Area<T> operator+(const Area<T>& a, const Area<T>& b) {
  return {a.vector + b.vector, a.size + b.size};
}
/// An Area per lane.
template <class T, int N>
struct LaneArea {
  LaneVec3<T, N> vector;
  alignas(N == 1 ? alignof(T) : 64) T size[N];

  WEFT_HD Area<T> get(int l) const { return {vector.get(l), size[l]}; }
  WEFT_HD void set(int l, const Area<T>& area) {
    vector.set(l, area.vector);
    size[l] = area.size;
  }
};

template <class T, class Fan>
struct VertexNormals {
  Fan fan;
  const ClothParams<T>* cloths;
  const int32_t* cloth_of_block;
  Vec3Array<T> x, out;
  int first_block;

  template <int N>
  WEFT_HD void operator()(int index, int lane0, Lanes<N> lanes) const {
    const int block = first_block + index;
    const int i0 = block * block_size + lane0;
    const ClothParams<T>& cloth = cloths[cloth_of_block[block]];
    LaneArea<T, N> sum;
    const Vec3Array<T> from = x;
    fan.sum_triangles(
        cloth, block, i0, lanes, [=](int i) WEFT_LANE { return load(from, i); },
        [=](Vec3<T> here, Vec3<T> next, Vec3<T> last) WEFT_LANE {
          const Vec3<T> area = cross(next - here, last - here);
          return Area<T>{area, magnitude(area.x) + magnitude(area.y) + magnitude(area.z)};
        },
        sum);
    lanes.each([&](int l)
                   WEFT_LANE { store(out, i0 + l, unit_or_zero(sum.vector.get(l), sum.size[l])); });
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
