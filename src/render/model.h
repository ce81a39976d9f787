// Triangles on the device.
#pragma once

#include "render/gl.h"
#include "render/solids.h"

namespace weft::render {

/// Triangles in buffers of their own.
class Model {
 public:
  explicit Model(const Triangles&);
  void draw() const;
  void draw_instances(size_t count) const;
  const VertexArray& array() const { return array_; }

 private:
  VertexArray array_;
  Buffer vertices_, indices_;
  GLsizei count_;
};

}  // namespace weft::render
