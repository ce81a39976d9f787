// Fills a host image of a world's device memory from the records.
#pragma once

#include "api/arena/arena.h"
#include "api/context/vector_math.h"

namespace weft::api {

/// Everything but colliders, pins and motions, which change from frame to frame. Sets the records'
/// places in the arena.
template <class T>
void fill_image(const ArenaInput&, const plan::Layout&, int particle_step, double dt_before,
                double time, char* image);

/// Which particles each group of the survey looks at; after fill_image.
void fill_survey_ranges(const ArenaInput&, const plan::Layout&, char* image);

/// Parameters of the cloths; `starting` marks those that have not moved.
template <class T>
void fill_params(const ArenaInput&, std::vector<ClothParams<T>>& out);

inline int slices_of(const ClothRecord& cloth) {
  return static_cast<int>((cloth.cooked().vertices + block_size - 1) / block_size);
}

template <class T>
Vec3<T> narrow(const double3& v) {
  return {static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)};
}
/// Vectors in the memory layout of a back end.
template <class T>
Vec3Array<T> arranged(const std::vector<Vec3<T>>& values, size_t step, std::vector<T>& memory) {
  const size_t pitch = step > 1 ? 1 : values.size();
  memory.resize(values.size() * (step > 1 ? step : 3));
  for (size_t i = 0; i < values.size(); ++i) {
    memory[i * step] = values[i].x;
    memory[i * step + pitch] = values[i].y;
    memory[i * step + 2 * pitch] = values[i].z;
  }
  return {memory.data(), pitch};
}
/// Element i of an array of vectors in an image.
template <class T>
class VectorWriter {
 public:
  VectorWriter(const plan::VectorArray& array, int step, char* image)
      : data_(reinterpret_cast<T*>(image + array.offset)), pitch_(array.pitch), step_(step) {}
  void set(int64_t i, const Vec3<T>& v) const {
    T* p = data_ + i * step_;
    p[0] = v.x;
    p[pitch_] = v.y;
    p[2 * pitch_] = v.z;
  }
  Vec3<T> get(int64_t i) const {
    const T* p = data_ + i * step_;
    return {p[0], p[pitch_], p[2 * pitch_]};
  }

 private:
  T* data_;
  size_t pitch_;
  int64_t step_;
};

}  // namespace weft::api
