#include "api/arena/collider_mesh_arrays.h"

#include <algorithm>

#include "api/arena/image.h"

namespace weft::api {

namespace {

template <class T, class From>
void copy_as(const scene::Array<From>& from, const void* to) {
  T* out = static_cast<T*>(const_cast<void*>(to));
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

GridCounts grid_counts(const scene::CookedColliderMesh& m) {
  const auto count = [](size_t n) { return static_cast<int64_t>(n); };
  const int64_t triangles = count(m.planes.size() / 16);
  return {count(brick_words(m)), count(m.cell_start.size()), count(m.entry_triangle.size()),
          triangles, m.closed ? triangles : 0};
}

template <class T>
void fill_grid(const scene::CookedColliderMesh& m, const TriangleGrid<T>& image) {
  static_assert(sizeof(TrianglePlanes<T>) == 16 * sizeof(T));
  static_assert(sizeof(TriangleCorners<T>) == 9 * sizeof(T));
  static_assert(sizeof(TriangleSides<T>) == 18 * sizeof(T));
  copy_as<int32_t>(m.cell_start, image.cell_start);
  copy_as<int32_t>(m.entry_triangle, image.entry_triangle);
  copy_as<T>(m.planes, image.planes);
  copy_as<T>(m.corners, image.corners);
  if (m.closed) copy_as<T>(m.sides, image.sides);
  mark_bricks(m, writable(image.occupied));
}

template <class T>
void set_numbers(const scene::CookedColliderMesh& m, TriangleGrid<T>& grid) {
  grid.low = {T(m.grid_low.x), T(m.grid_low.y), T(m.grid_low.z)};
  grid.cell_size = T(m.cell_size);
  grid.inverse_cell_size = T(1 / m.cell_size);
  for (int axis = 0; axis < 3; ++axis) grid.cells[axis] = m.cells[axis];
  grid.thickness = T(m.thickness);
  grid.closed = m.closed ? 1 : 0;
}

template void fill_grid(const scene::CookedColliderMesh&, const TriangleGrid<float>&);
template void fill_grid(const scene::CookedColliderMesh&, const TriangleGrid<double>&);
template void set_numbers(const scene::CookedColliderMesh&, TriangleGrid<float>&);
template void set_numbers(const scene::CookedColliderMesh&, TriangleGrid<double>&);

}  // namespace weft::api
