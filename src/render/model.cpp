#include "render/model.h"

namespace weft::render {

Model::Model(const Triangles& triangles) : count_(GLsizei(triangles.indices.size())) {
  glBindVertexArray(array_.name());
  const auto& vertices = triangles.vertices;
  const size_t stride = sizeof vertices[0];
  fill(vertices_, GL_ARRAY_BUFFER, vertices.data(), vertices.size() * stride, GL_STATIC_DRAW);
  fill(indices_, GL_ELEMENT_ARRAY_BUFFER, triangles.indices.data(),
       triangles.indices.size() * sizeof(uint32_t), GL_STATIC_DRAW);
  attribute(0, vertices_, 3, stride, 0);
  attribute(1, vertices_, 3, stride, 3 * sizeof(float));
}

void Model::draw() const {
  glBindVertexArray(array_.name());
  glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

void Model::draw_instances(size_t count) const {
  glBindVertexArray(array_.name());
  glDrawElementsInstanced(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr, GLsizei(count));
}

}  // namespace weft::render
