// A triangle mesh that particles collide with: a dense grid whose cells list the triangles that can
// be the nearest one to a point in the cell.
#pragma once

#include "base/view.h"

namespace weft {

/// Four planes dot((x, y, z), p) - offset of a triangle: its own, then those that stand on its
/// edges (corner i to corner i + 1), positive outside. Component by component, so that one vector
/// operation gives all four; in float a cache line.
template <class T>
struct alignas(64) TrianglePlanes {
  T x[4], y[4], z[4], offset[4];
};

template <class T>
struct TriangleCorners {
  Vec3<T> corner[3];
};

/// Unit pseudonormals of the three edges, then of the three corners (Baerentzen & Aanaes 2005).
template <class T>
struct TriangleSides {
  Vec3<T> normal[6];
};

/// Cell (i, j, k) is number (k * cells[1] + j) * cells[0] + i. Its list starts at the entry that
/// cell_start gives, with the triangle nearest to its centre, and ends with an entry that holds the
/// complement ~triangle. Without a list: no_list where nothing is nearer than the thickness; deep
/// inside a closed mesh deep_inside - triangle, for some triangle nearby.
constexpr int32_t no_list = -1, deep_inside = -2;
/// Cells are summed up in bricks of 2 x 2 x 2, so that most points are known to be far from all
/// triangles without a look at their cell.
constexpr int32_t brick_edge = 2;
/// Pieces of half a thickness that the way of a fast particle through the grid is walked in, at
/// most: cooking refuses a thickness for which that would not do.
constexpr int32_t most_sweep_pieces = 1 << 20;
struct GridCounts {
  int64_t brick_words, cells, entries, triangles;
  int64_t with_sides;  ///< of the triangles
};
template <class T>
struct TriangleGrid {
  Vec3<T> low;  ///< corner of cell 0
  T cell_size, inverse_cell_size;
  int32_t cells[3];
  T thickness;
  int32_t closed;            ///< 1: has an inside
  const uint32_t* occupied;  ///< a bit per brick: some cell of it has a list
  const int32_t* cell_start;
  const int32_t* entry_triangle;
  const TrianglePlanes<T>* planes;
  const TriangleCorners<T>* corners;
  const TriangleSides<T>* sides;  ///< null unless closed

  template <class Arrays>
  constexpr void arrays(Arrays& array, const GridCounts& n) {
    array.later(low, cell_size, inverse_cell_size, cells, thickness, closed);
    array(cell_start, n.cells);
    array(entry_triangle, n.entries);
    array(planes, n.triangles);
    array(corners, n.triangles);
    array(sides, n.with_sides);
    array(occupied, n.brick_words);
  }
};

/// What one particle remembers of its last full search: the triangles of the list with the least
/// bounds, and how far away at least all later ones were. As long as the particle is in the same
/// cell and has not moved so far that another could have come nearer, looking at these few, or at
/// the first of them, gives what looking at all would: the same bits, whatever the memory's age.
constexpr int most_remembered = 10;
template <class T>
struct NearMemory {
  Vec3<T> at;
  T free;                             ///< m: within this of `at` nothing is near
  int32_t mesh;                       ///< number of the collider, from 1; 0: nothing is remembered
  int32_t cell;                       ///< number of the cell
  int32_t triangle[most_remembered];  ///< -1: no more
  T later[most_remembered];           ///< m: no triangle behind this one was nearer to `at`
};

}  // namespace weft
