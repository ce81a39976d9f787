#include "render/model.h"

namespace weft::render {

Model::Model(const Triangles& triangles, const Vector3d& origin)
    : count_(GLsizei(triangles.indices.size())) {
  std::vector<Vector3f> vertices;
  for (size_t v = 0; v < triangles.places.size(); ++v) {
    vertices.push_back((triangles.places[v] - origin).cast<float>());
    vertices.push_back(triangles.normals[v].cast<float>());
  }
  constexpr size_t one = sizeof(Vector3f);
  glBindVertexArray(array_.name());
  fill(vertices_, GL_ARRAY_BUFFER, vertices.data(), vertices.size() * one, GL_STATIC_DRAW);
  fill(indices_, GL_ELEMENT_ARRAY_BUFFER, triangles.indices.data(),
       triangles.indices.size() * sizeof(uint32_t), GL_STATIC_DRAW);
  attribute(0, vertices_, 3, 2 * one, 0);
  attribute(1, vertices_, 3, 2 * one, one);
}

void Model::draw(size_t instances) const {
  glBindVertexArray(array_.name());
  glDrawElementsInstanced(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr, GLsizei(instances));
}

}  // namespace weft::render
