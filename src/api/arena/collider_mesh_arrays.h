// A cooked collider mesh as a world keeps it on the device, in the world's scalar.
#pragma once

#include "plan/effects.h"
#include "scene/collider_mesh.h"
#include "step/backend.h"

namespace weft::api {

/// cell_start, entry_triangle, planes, corners, sides, occupied; in this order everywhere.
constexpr int mesh_arrays = 6;

/// 0: there is no such array. `planes` must be aligned to 64 bytes.
struct MeshArraySizes {
  size_t bytes[mesh_arrays];
};
template <class T>
MeshArraySizes array_sizes(const scene::CookedColliderMesh&);
/// Writes the arrays to host memory, narrowed to T.
template <class T>
void write_arrays(const scene::CookedColliderMesh&, char* const (&destinations)[mesh_arrays]);
/// The view of arrays that lie at these addresses of the device.
template <class T>
TriangleGrid<T> grid_of(const scene::CookedColliderMesh&,
                        const char* const (&addresses)[mesh_arrays]);

/// The sizes for a world's plan.
inline plan::MeshArrays bytes_on_device(const scene::CookedColliderMesh& mesh,
                                        Precision precision) {
  const MeshArraySizes sizes =
      precision == Precision::float64 ? array_sizes<double>(mesh) : array_sizes<float>(mesh);
  static_assert(plan::MeshArrays::count == mesh_arrays);
  plan::MeshArrays arrays{};
  for (int a = 0; a < mesh_arrays; ++a) arrays.of[a] = sizes.bytes[a];
  return arrays;
}

}  // namespace weft::api
