// Writing to an image of a world's device memory: its views are those of the kernels.
#pragma once

#include "api/records/cloth.h"
#include "base/memory_host.h"
#include "base/view.h"

namespace weft::api {

/// What kernels only read, the host fills.
template <class Element>
Element* writable(const Element* view) {
  return const_cast<Element*>(view);
}

inline int slices_of(const ClothRecord& cloth) {
  return static_cast<int>((cloth.cooked().vertices + block_size - 1) / block_size);
}

template <class T>
Vec3<T> narrow(const double3& v) {
  return {static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)};
}
/// Vectors in the memory layout of a back end.
template <class T>
Vec3Array<T> arranged(const Vector<Vec3<T>>& values, size_t stride, Vector<T>& memory) {
  const size_t pitch = stride > 1 ? 1 : values.size();
  memory.resize(values.size() * (stride > 1 ? stride : 3));
  for (size_t i = 0; i < values.size(); ++i) {
    memory[i * stride] = values[i].x;
    memory[i * stride + pitch] = values[i].y;
    memory[i * stride + 2 * pitch] = values[i].z;
  }
  return {memory.data(), pitch};
}

/// Elements of an array of vectors.
template <class T>
class VectorWriter {
 public:
  VectorWriter(const Vec3Array<T>& array, int stride) : array_(array), stride_(stride) {}
  void set(int64_t i, const Vec3<T>& v) const {
    T* p = array_.data + i * stride_;
    p[0] = v.x;
    p[array_.pitch] = v.y;
    p[2 * array_.pitch] = v.z;
  }

 private:
  Vec3Array<T> array_;
  int64_t stride_;
};

}  // namespace weft::api
