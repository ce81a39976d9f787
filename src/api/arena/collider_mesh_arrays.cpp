#include "api/arena/collider_mesh_arrays.h"

#include <algorithm>

namespace weft::api {

namespace {

template <class T, class From>
void narrow(const scene::Array<From>& from, char* to) {
  T* out = reinterpret_cast<T*>(to);
  for (size_t i = 0; i < from.size(); ++i) out[i] = static_cast<T>(from[i]);
}

int32_t bricks(int32_t cells) { return (cells + brick_edge - 1) / brick_edge; }

size_t brick_words(const scene::CookedColliderMesh& m) {
  const auto all =
      size_t(bricks(m.cells[0])) * size_t(bricks(m.cells[1])) * size_t(bricks(m.cells[2]));
  return (all + 31) / 32;
}

void mark_bricks(const scene::CookedColliderMesh& m, uint32_t* words) {
  std::fill_n(words, brick_words(m), 0u);
  const int32_t x = bricks(m.cells[0]), y = bricks(m.cells[1]);
  size_t cell = 0;
  for (int32_t k = 0; k < m.cells[2]; ++k) {
    for (int32_t j = 0; j < m.cells[1]; ++j) {
      for (int32_t i = 0; i < m.cells[0]; ++i, ++cell) {
        if (m.cell_start[cell] == no_list) continue;
        const int32_t brick = (k / brick_edge * y + j / brick_edge) * x + i / brick_edge;
        words[brick / 32] |= 1u << (brick % 32);
      }
    }
  }
}

}  // namespace

template <class T>
MeshArraySizes array_sizes(const scene::CookedColliderMesh& m) {
  static_assert(sizeof(TrianglePlanes<T>) == 16 * sizeof(T));
  static_assert(sizeof(TriangleCorners<T>) == 9 * sizeof(T));
  static_assert(sizeof(TriangleSides<T>) == 18 * sizeof(T));
  return {{m.cell_start.size() * sizeof(int32_t), m.entry_triangle.size() * sizeof(int32_t),
           m.planes.size() * sizeof(T), m.corners.size() * sizeof(T), m.sides.size() * sizeof(T),
           brick_words(m) * sizeof(uint32_t)}};
}

template <class T>
void write_arrays(const scene::CookedColliderMesh& m, char* const (&destinations)[mesh_arrays]) {
  narrow<int32_t>(m.cell_start, destinations[0]);
  narrow<int32_t>(m.entry_triangle, destinations[1]);
  narrow<T>(m.planes, destinations[2]);
  narrow<T>(m.corners, destinations[3]);
  narrow<T>(m.sides, destinations[4]);
  mark_bricks(m, reinterpret_cast<uint32_t*>(destinations[5]));
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
  grid.occupied = reinterpret_cast<const uint32_t*>(addresses[5]);
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
