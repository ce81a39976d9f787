// Triangles on the device.
#pragma once

#include "render/gl.h"
#include "render/solids.h"

namespace weft::render {

/// Triangles relative to the picture's origin, in buffers of their own.
class Model {
 public:
  Model(const Triangles&, const Vector3d& origin);
  void draw(size_t instances = 1) const;
  const VertexArray& array() const { return array_; }

 private:
  VertexArray array_;
  Buffer vertices_, indices_;
  GLsizei count_;
};

}  // namespace weft::render
