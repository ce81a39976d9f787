// Arrays of vectors between device memory and the host, and within it.
#pragma once

#include "api/arena/arena.h"
#include "api/arena/image.h"

namespace weft::api {

/// All particles of an array to another.
template <class T>
Status copy_vectors(const Backend& backend, const Vec3Array<T>& from, const Vec3Array<T>& to,
                    int blocks) {
  const auto elements = static_cast<size_t>(blocks) * block_size;
  const auto stride = static_cast<size_t>(backend.info().vector_stride);
  if (stride > 1) return backend.copy(to.data, from.data, elements * stride * sizeof(T));
  Status status = Status::ok;
  for (size_t c = 0; c < 3 && status == Status::ok; ++c) {
    status = backend.copy(to.data + c * to.pitch, from.data + c * from.pitch, elements * sizeof(T));
  }
  return status;
}

/// Reads elements [first, first + count).
template <class T>
Status fetch_vectors(const Backend& backend, const Vec3Array<T>& from, int first, size_t count,
                     Vector<Vec3<T>>& out) {
  out.resize(count);
  if (count == 0) return Status::ok;
  const auto stride = static_cast<size_t>(backend.info().vector_stride);
  Vector<T> line((count - 1) * stride + 1);
  for (size_t c = 0; c < 3; ++c) {
    const Status status = backend.to_host(
        line.data(), from.data + size_t(first) * stride + c * from.pitch, line.size() * sizeof(T));
    if (status != Status::ok) return status;
    T Vec3<T>::*const member = c == 0 ? &Vec3<T>::x : c == 1 ? &Vec3<T>::y : &Vec3<T>::z;
    for (size_t i = 0; i < count; ++i) out[i].*member = line[i * stride];
  }
  return Status::ok;
}

/// From the cloth's first element on, where the host can read it.
template <class T>
Status on_host(const ContextState& context, const Vec3Array<T>& from, const ClothRecord& cloth,
               Vector<T>& mirror, Vec3Array<T>& out) {
  const BackendInfo& device = context.backend->info();
  if (device.host_memory) {
    out = {from.data + int64_t(cloth.first()) * device.vector_stride, from.pitch};
    return Status::ok;
  }
  Vector<Vec3<T>> values;
  const Status status =
      fetch_vectors(*context.backend, from, cloth.first(), cloth.cooked().vertices, values);
  if (status != Status::ok) return status;
  out = arranged(values, static_cast<size_t>(context.host().info().vector_stride), mirror);
  return Status::ok;
}

}  // namespace weft::api
