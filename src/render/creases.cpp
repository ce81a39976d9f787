// Normals of a mesh that is smooth here and sharp there.
#include "render/solids.h"

#include <Eigen/Geometry>

namespace weft::render {

Triangles with_creases(const std::vector<Vector3d>& places, const std::vector<uint32_t>& indices) {
  constexpr double crease = 0.766;
  std::vector<Vector3d> areas;
  std::vector<uint32_t> start(places.size() + 1, 0);  // the corners of vertex v: start[v], ...
  for (size_t c = 0; c + 2 < indices.size(); c += 3) {
    const Vector3d a = places[indices[c]];
    areas.push_back((places[indices[c + 1]] - a).cross(places[indices[c + 2]] - a));
    for (size_t k = 0; k < 3; ++k) ++start[indices[c + k] + 1];
  }
  for (size_t v = 0; v < places.size(); ++v) start[v + 1] += start[v];
  std::vector<uint32_t> corners(3 * areas.size()), next(start.begin(), start.end() - 1);
  for (uint32_t c = 0; c < corners.size(); ++c) corners[next[indices[c]]++] = c;

  Triangles drawn;
  drawn.indices.resize(corners.size());
  for (size_t v = 0; v < places.size(); ++v) {
    const size_t first = drawn.places.size();
    for (uint32_t i = start[v]; i < start[v + 1]; ++i) {
      const Vector3d& own = areas[corners[i] / 3];
      Vector3d sum(0, 0, 0);
      for (uint32_t j = start[v]; j < start[v + 1]; ++j) {
        const Vector3d& other = areas[corners[j] / 3];
        if (own.dot(other) >= crease * own.norm() * other.norm()) sum += other;
      }
      const Vector3d normal = sum.normalized();
      size_t at = first;
      while (at < drawn.normals.size() && drawn.normals[at] != normal) ++at;
      if (at == drawn.normals.size()) {
        drawn.places.push_back(places[v]);
        drawn.normals.push_back(normal);
      }
      drawn.indices[corners[i]] = uint32_t(at);
    }
  }
  return drawn;
}

}  // namespace weft::render
