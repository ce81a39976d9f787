// A cooked collider mesh with its arrays in scalar T, as a world has it on the device.
#pragma once

#include "reference/brute_mesh.h"

#include "api/arena/collider_mesh_arrays.h"

namespace reference {

inline weft::scene::CookedColliderMesh cook(const Triangles& mesh, double thickness, bool closed) {
  std::vector<uint32_t> indices;
  for (const auto& f : mesh.faces) indices.insert(indices.end(), f.begin(), f.end());
  std::vector<weft::double3> positions;
  for (const Vec v : mesh.vertices) positions.push_back({v.x, v.y, v.z});
  weft::ColliderMeshDesc desc;
  desc.positions = weft::View<weft::double3>(positions);
  desc.indices = indices;
  desc.thickness = thickness;
  desc.closed = closed;
  weft::scene::CookedColliderMesh cooked(std::pmr::new_delete_resource());
  weft::scene::cook_collider_mesh(desc, cooked);
  return cooked;
}

template <class T>
class MeshOnDevice {
 public:
  explicit MeshOnDevice(const weft::scene::CookedColliderMesh& cooked) {
    const auto sizes = weft::api::array_sizes<T>(cooked);
    char* to[weft::api::mesh_arrays];
    const char* at[weft::api::mesh_arrays];
    for (size_t a = 0; a < weft::api::mesh_arrays; ++a) {
      lines_[a].resize(sizes.bytes[a] / sizeof(Line) + 1);
      at[a] = to[a] = lines_[a].data()->bytes;
    }
    weft::api::write_arrays<T>(cooked, to);
    grid = weft::api::grid_of<T>(cooked, at);
  }
  MeshOnDevice(const MeshOnDevice&) = delete;
  MeshOnDevice& operator=(const MeshOnDevice&) = delete;

  weft::TriangleGrid<T> grid;

 private:
  struct alignas(64) Line {
    char bytes[64];
  };
  std::vector<Line> lines_[weft::api::mesh_arrays];
};

}  // namespace reference
