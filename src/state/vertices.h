// What works on the vertices of one cloth: a write into a vertex buffer of the caller, and a change
// of origin.
#pragma once

#include "base/view.h"

namespace weft {

/// How an attribute is stored; weft::Format of the public interface.
enum class VertexFormat : int32_t { none, f32x3, f32x4, f16x4, snorm8x4, snorm16x4, oct16x2 };

struct VertexAttribute {
  VertexFormat format;
  char* data;  ///< of vertex 0 of the cloth; any alignment
  int64_t stride;
};

/// A cloth's positions relative to another origin.
template <class T>
struct OriginJob {
  int particles;
  Vec3Array<T> x;  ///< of the cloth's element 0
  Vec3<T> by;      ///< m: the new origin seen from the old one
};

template <class T>
struct VertexJob {
  int vertices;
  const uint32_t* storage;   ///< by vertex: its element; null: the same
  Vec3Array<T> now, before;  ///< of the cloth's element 0
  Vec3Array<T> normal;       ///< read only where an attribute wants it
  T alpha;                   ///< from before to now; 1: `before` is not read
  Vec3<double> shift;        ///< m, from the cloth's local frame to the buffer's
  Vec3<float>* last;         ///< by vertex, what was written before; null: nobody wants it
  VertexAttribute out_position, out_normal, out_last;
};

}  // namespace weft
