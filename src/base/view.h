// Views of device memory. Vec3Array hides the memory layout of vectors: kernels only load and
// store.
#pragma once

#include "base/vec3.h"

namespace weft {

/// Array of vectors; component c of element i is data[i * vector_stride + c * pitch].
template <class T>
struct Vec3Array {
  T* data;
  size_t pitch;
};

namespace WEFT_BACKEND_NS {

constexpr ptrdiff_t vector_stride = WEFT_VECTOR_STRIDE;

template <class T>
WEFT_HD Vec3<T> load(Vec3Array<T> a, int i) {
  const T* p = a.data + i * vector_stride;
  return {p[0], p[a.pitch], p[2 * a.pitch]};
}
template <class T>
WEFT_HD void store(Vec3Array<T> a, int i, Vec3<T> v) {
  T* p = a.data + i * vector_stride;
  p[0] = v.x;
  p[a.pitch] = v.y;
  p[2 * a.pitch] = v.z;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
