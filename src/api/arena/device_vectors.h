// Whole arrays of vectors in device memory.
#pragma once

#include "base/memory_host.h"
#include "step/backend.h"

namespace weft::api {

/// All particles of `blocks` blocks, from one array of vectors to another.
template <class T>
Status copy_vectors(const Backend& backend, const Vec3Array<T>& from, const Vec3Array<T>& to,
                    int blocks) {
  const auto stride = static_cast<size_t>(backend.info().vector_stride);
  const size_t bytes = static_cast<size_t>(blocks) * block_size * sizeof(T);
  if (stride > 1) return backend.copy(to.data, from.data, bytes * stride);
  Status status = Status::ok;
  for (size_t c = 0; c < 3 && status == Status::ok; ++c) {
    status = backend.copy(to.data + c * to.pitch, from.data + c * from.pitch, bytes);
  }
  return status;
}

/// Reads elements [first, first + count) of an array of vectors.
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

}  // namespace weft::api
