// A cooked collider mesh with its arrays in scalar T, as a world has it on the device.
#pragma once

#include "reference/brute_mesh.h"

#include "api/arena/collider_mesh_arrays.h"
#include "plan/cutter.h"

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
    const weft::GridCounts counts = weft::api::grid_counts(cooked);
    lines_.resize(cut(nullptr, counts) / sizeof(Line));
    cut(lines_.data()->bytes, counts);
    weft::api::fill_grid(cooked, grid);
    weft::api::set_numbers(cooked, grid);
  }
  MeshOnDevice(const MeshOnDevice&) = delete;
  MeshOnDevice& operator=(const MeshOnDevice&) = delete;

  weft::TriangleGrid<T> grid{};

 private:
  struct alignas(128) Line {
    char bytes[128];
  };
  size_t cut(char* base, const weft::GridCounts& counts) {
    weft::plan::Cutter cutter(base, 1);
    cutter.group(grid, counts);
    return cutter.bytes();
  }
  std::vector<Line> lines_;
};

}  // namespace reference
