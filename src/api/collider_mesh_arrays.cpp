#include "api/collider_mesh_arrays.h"

namespace weft::api {

namespace {

template <class T, class From>
void narrow(const scene::Array<From>& from, char* to) {
  T* out = reinterpret_cast<T*>(to);
  for (size_t i = 0; i < from.size(); ++i) out[i] = static_cast<T>(from[i]);
}

}  // namespace

template <class T>
MeshArraySizes array_sizes(const scene::CookedColliderMesh& m) {
  static_assert(sizeof(TrianglePlanes<T>) == 16 * sizeof(T));
  static_assert(sizeof(TriangleCorners<T>) == 9 * sizeof(T));
  static_assert(sizeof(TriangleSides<T>) == 18 * sizeof(T));
  return {{m.cell_start.size() * sizeof(int32_t), m.entry_triangle.size() * sizeof(int32_t),
           m.planes.size() * sizeof(T), m.corners.size() * sizeof(T), m.sides.size() * sizeof(T)}};
}

template <class T>
void write_arrays(const scene::CookedColliderMesh& m, char* const (&destinations)[mesh_arrays]) {
  narrow<int32_t>(m.cell_start, destinations[0]);
  narrow<int32_t>(m.entry_triangle, destinations[1]);
  narrow<T>(m.planes, destinations[2]);
  narrow<T>(m.corners, destinations[3]);
  narrow<T>(m.sides, destinations[4]);
}

template <class T>
TriangleGrid<T> grid_of(const scene::CookedColliderMesh& m,
                        const char* const (&addresses)[mesh_arrays]) {
  TriangleGrid<T> grid{};
  grid.low = {T(m.grid_low.x), T(m.grid_low.y), T(m.grid_low.z)};
  grid.cell_size = T(m.cell_size);
  grid.inverse_cell_size = T(1 / m.cell_size);
  for (int axis = 0; axis < 3; ++axis) grid.cells[axis] = m.cells[axis];
  grid.thickness = T(m.thickness);
  grid.closed = m.closed ? 1 : 0;
  grid.cell_start = reinterpret_cast<const int32_t*>(addresses[0]);
  grid.entry_triangle = reinterpret_cast<const int32_t*>(addresses[1]);
  grid.planes = reinterpret_cast<const TrianglePlanes<T>*>(addresses[2]);
  grid.corners = reinterpret_cast<const TriangleCorners<T>*>(addresses[3]);
  if (m.closed) grid.sides = reinterpret_cast<const TriangleSides<T>*>(addresses[4]);
  return grid;
}

template MeshArraySizes array_sizes<float>(const scene::CookedColliderMesh&);
template MeshArraySizes array_sizes<double>(const scene::CookedColliderMesh&);
template void write_arrays<float>(const scene::CookedColliderMesh&, char* const (&)[mesh_arrays]);
template void write_arrays<double>(const scene::CookedColliderMesh&, char* const (&)[mesh_arrays]);
template TriangleGrid<float> grid_of(const scene::CookedColliderMesh&,
                                     const char* const (&)[mesh_arrays]);
template TriangleGrid<double> grid_of(const scene::CookedColliderMesh&,
                                      const char* const (&)[mesh_arrays]);

}  // namespace weft::api
