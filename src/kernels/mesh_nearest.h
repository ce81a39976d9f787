// The nearest point of a triangle mesh, exact for every point whose cell has entries.
//
// The list of a cell holds about the triangles below it. Four plane distances bound a triangle's
// distance from below, exactly over the face; only triangles with the least bounds are measured.
#pragma once

#include "kernels/colliders.h"
#include "state/collider_mesh.h"

namespace weft {
namespace WEFT_BACKEND_NS {

struct Cell {
  int i, j, k;
};

/// Along one axis; -1 outside the grid, also for what is not a number.
template <class T>
WEFT_HD int cell_along(T from_low, T inverse_size, int32_t cells) {
  const T f = from_low * inverse_size;
  return f >= T(0) && f < T(cells) ? int(f) : -1;
}
template <class T>
WEFT_HD Cell cell_of(const TriangleGrid<T>& grid, Vec3<T> x) {
  const Vec3<T> from = x - grid.low;
  return {cell_along(from.x, grid.inverse_cell_size, grid.cells[0]),
          cell_along(from.y, grid.inverse_cell_size, grid.cells[1]),
          cell_along(from.z, grid.inverse_cell_size, grid.cells[2])};
}
template <class T>
WEFT_HD int clamped_along(T from_low, T inverse_size, int32_t cells) {
  const T f = from_low * inverse_size;
  return f >= T(0) ? (f < T(cells) ? int(f) : cells - 1) : 0;
}
template <class T>
WEFT_HD Cell clamped_cell(const TriangleGrid<T>& grid, Vec3<T> x) {
  const Vec3<T> from = x - grid.low;
  return {clamped_along(from.x, grid.inverse_cell_size, grid.cells[0]),
          clamped_along(from.y, grid.inverse_cell_size, grid.cells[1]),
          clamped_along(from.z, grid.inverse_cell_size, grid.cells[2])};
}

template <class T>
WEFT_HD int32_t bricks_along(const TriangleGrid<T>& grid, int axis) {
  return (grid.cells[axis] + brick_edge - 1) / brick_edge;
}
/// Whether any cell of a brick has a list.
template <class T>
WEFT_HD bool is_occupied(const TriangleGrid<T>& grid, int32_t brick) {
  return ((grid.occupied[brick >> 5] >> (brick & 31)) & 1u) != 0;
}

template <class T>
WEFT_HD int32_t cell_number(const TriangleGrid<T>& grid, Cell c) {
  return (c.k * grid.cells[1] + c.j) * grid.cells[0] + c.i;
}

template <class T>
WEFT_HD void plane_values(const TrianglePlanes<T>& p, Vec3<T> x, T* value) {
  WEFT_SIMD
  for (int i = 0; i < 4; ++i) {
    value[i] = p.x[i] * x.x + p.y[i] * x.y + p.z[i] * x.z - p.offset[i];
  }
}

template <class T>
WEFT_HD Vec3<T> face_normal(const TriangleGrid<T>& grid, int32_t triangle) {
  const TrianglePlanes<T>& p = grid.planes[triangle];
  return {p.x[0], p.y[0], p.z[0]};
}

template <class T>
struct Nearest {
  int32_t triangle;  ///< -1: none, nothing is nearer than the thickness
  int32_t feature;   ///< -1: the face; 0 to 2: an edge; 3 to 5: a corner
  bool inside;       ///< of a closed mesh
  Vec3<T> away;      ///< from the nearest point
  T distance2;
};

/// From the nearest point of edge e.
template <class T>
WEFT_HD void nearest_on_edge(const TriangleCorners<T>& t, int e, Vec3<T> x, Nearest<T>& found) {
  const int next = e == 2 ? 0 : e + 1;
  const Vec3<T> edge = t.corner[next] - t.corner[e], from = x - t.corner[e];
  const T along = dot(from, edge), length2 = dot(edge, edge);
  const bool before = !(along > T(0)), after = along >= length2;
  const Vec3<T> within = from - (along / length2) * edge;
  found.away = select(before, from, select(after, x - t.corner[next], within));
  found.distance2 = dot(found.away, found.away);
  found.feature = before ? 3 + e : (after ? 3 + next : e);
}

/// For a point that is outside of one or two edges: the nearest point is on one of those.
template <class T>
WEFT_HD void nearest_on_edges(const TriangleCorners<T>& t, const T* outside, Vec3<T> x,
                              Nearest<T>& found) {
  const int of_two = outside[1] > outside[0] ? 1 : 0;
  const int farthest = outside[2] > outside[of_two] ? 2 : of_two;
  nearest_on_edge(t, farthest, x, found);
  const int after = farthest == 2 ? 0 : farthest + 1, before = 3 - farthest - after;
  const int other = outside[after] > outside[before] ? after : before;
  if (!(outside[other] > T(0))) return;
  Nearest<T> second = found;
  nearest_on_edge(t, other, x, second);
  if (second.distance2 < found.distance2) found = second;
}

/// On which side of a closed mesh. The pseudonormal of the nearest feature tells.
template <class T>
WEFT_HD bool lies_inside(const TriangleGrid<T>& grid, const Nearest<T>& near) {
  const Vec3<T> n = near.feature < 0 ? face_normal(grid, near.triangle)
                                     : grid.sides[near.triangle].normal[near.feature];
  return dot(near.away, n) < T(0);
}

/// At most the squared distance to a triangle, and just that above its face.
template <class T>
WEFT_HD T bound2(const T* value) {
  const T beyond = larger(larger(value[1], value[2]), larger(value[3], T(0)));
  return value[0] * value[0] + beyond * beyond;
}

/// Rounding of a plane distance. A triangle is passed over only when its bound is above the best
/// distance by more: which one wins does not depend on the order of the list.
template <class T>
struct Rounding {
  T distance, square;
};
template <class T>
WEFT_HD Rounding<T> rounding_at(const TriangleGrid<T>& grid, Vec3<T> x) {
  const T epsilon = sizeof(T) == 4 ? T(1e-6) : T(2e-15);
  const T e = epsilon * (magnitude(x.x) + magnitude(x.y) + magnitude(x.z) + grid.thickness);
  return {e, e * (T(4) * grid.thickness + e)};
}

/// The triangle becomes `best` if it is nearer; of equally near ones the lower number.
template <class T>
WEFT_HD void measure(const TriangleGrid<T>& grid, int32_t triangle, const T* value, Vec3<T> x,
                     Nearest<T>& best) {
  Nearest<T> found{triangle, -1, false, {T(0), T(0), T(0)}, bound2(value)};
  if (larger(larger(value[1], value[2]), value[3]) > T(0)) {
    nearest_on_edges(grid.corners[triangle], value + 1, x, found);
  }
  const bool tie = found.distance2 == best.distance2 && triangle < best.triangle;
  if (found.distance2 < best.distance2 || tie) best = found;
}
template <class T>
WEFT_HD void measure_if_near(const TriangleGrid<T>& grid, int32_t triangle, Vec3<T> x,
                             const Rounding<T>& rounding, Nearest<T>& best) {
  T value[4];
  plane_values(grid.planes[triangle], x, value);
  if (bound2(value) > best.distance2 + rounding.square) return;
  measure(grid, triangle, value, x, best);
}

template <class T>
WEFT_HD void nearest_of_list(const TriangleGrid<T>& grid, const int32_t* list, Vec3<T> x,
                             const Rounding<T>& rounding, Nearest<T>& best) {
  int32_t entry = 0;
  do {
    entry = *list++;
    measure_if_near(grid, entry < 0 ? ~entry : entry, x, rounding, best);
  } while (entry >= 0);
}

/// The same, and keeps the triangles with the least bounds: every bound sinks into a sorted row of
/// few without a branch, so that the loads of many triangles overlap.
template <class T>
WEFT_HD_COLD void search_list(const TriangleGrid<T>& grid, const int32_t* list, Vec3<T> x,
                              const Rounding<T>& rounding, NearMemory<T>& memory,
                              Nearest<T>& best) {
  constexpr int kept = most_remembered;
  T bound[kept + 1];  // ascending; the last belongs to no remembered triangle
  int32_t triangle[kept + 1];
  for (int k = 0; k <= kept; ++k) {
    bound[k] = T(3e38);
    triangle[k] = -1;
  }
  int32_t entry = 0;
  for (const int32_t* at = list; entry >= 0; ++at) {
    entry = *at;
    int32_t t = entry < 0 ? ~entry : entry;
    T value[4];
    plane_values(grid.planes[t], x, value);
    T b = bound2(value);
    if (b >= bound[kept]) continue;
    WEFT_UNROLL
    for (int k = 0; k <= kept; ++k) {
      const bool less = b < bound[k];
      const T sinks = less ? bound[k] : b;
      const int32_t sinking = less ? triangle[k] : t;
      bound[k] = less ? b : bound[k];
      triangle[k] = less ? t : triangle[k];
      b = sinks;
      t = sinking;
    }
  }
  int k = 0;
  for (; k < kept && triangle[k] >= 0; ++k) {
    if (bound[k] > best.distance2 + rounding.square) break;
    measure_if_near(grid, triangle[k], x, rounding, best);
  }
  if (k == kept && bound[kept] <= best.distance2 + rounding.square) {
    nearest_of_list(grid, list, x, rounding, best);
  }
  memory.at = x;
  memory.free = square_root(bound[0]) - T(3) * rounding.distance - grid.thickness;
  for (int m = 0; m < kept; ++m) {
    memory.triangle[m] = triangle[m];
    memory.later[m] = square_root(bound[m + 1]) - T(3) * rounding.distance;
  }
}

/// Whether the remembered triangles were enough to find the nearest one.
template <class T>
WEFT_HD bool recall(const TriangleGrid<T>& grid, const NearMemory<T>& memory, T moved, Vec3<T> x,
                    const Rounding<T>& rounding, Nearest<T>& best) {
  for (int k = 0; k < most_remembered && memory.triangle[k] >= 0; ++k) {
    measure_if_near(grid, memory.triangle[k], x, rounding, best);
    // best + moved < later, without the root of the best
    const T left = memory.later[k] - moved;
    if (left > T(0) && best.distance2 < left * left) return true;
  }
  return false;
}

/// What cell_start has for the cell of x.
template <class T>
WEFT_HD int32_t list_of(const TriangleGrid<T>& grid, Vec3<T> x) {
  const Cell c = cell_of(grid, x);
  if ((c.i | c.j | c.k) < 0) return no_list;
  return grid.cell_start[cell_number(grid, c)];
}

template <class T>
WEFT_HD Nearest<T> no_triangle(const TriangleGrid<T>& grid) {
  return {-1,
          -1,
          false,
          {T(0), T(0), T(0)},
          grid.closed != 0 ? T(3e38) : grid.thickness * grid.thickness};
}

/// The last touches on the nearest triangle: its height above the face, and the side.
template <class T>
WEFT_HD Nearest<T> finish(const TriangleGrid<T>& grid, Vec3<T> x, bool deep, Nearest<T> best) {
  if (best.triangle < 0) return best;
  if (best.feature < 0) {  // from a corner the height is exact, from the offset it is rounded
    const Vec3<T> n = face_normal(grid, best.triangle);
    const T height = dot(n, x - grid.corners[best.triangle].corner[0]);
    best.away = height * n;
    best.distance2 = height * height;
  }
  if (grid.closed == 0) return best;
  best.inside = deep || lies_inside(grid, best);
  if (!best.inside && !(best.distance2 < grid.thickness * grid.thickness)) best.triangle = -1;
  return best;
}

/// Stateless: from the list of the cell of x.
template <class T>
WEFT_HD Nearest<T> nearest(const TriangleGrid<T>& grid, Vec3<T> x) {
  Nearest<T> best = no_triangle(grid);
  const int32_t start = list_of(grid, x);
  if (start == no_list) return best;
  if (start > deep_inside) {
    nearest_of_list(grid, grid.entry_triangle + start, x, rounding_at(grid, x), best);
  } else {
    T value[4];
    plane_values(grid.planes[deep_inside - start], x, value);
    measure(grid, deep_inside - start, value, x, best);
  }
  return finish(grid, x, start <= deep_inside, best);
}

/// The same, to the last bit, with the memory of a particle; `mesh` names the collider in it.
template <class T>
WEFT_HD Nearest<T> nearest(const TriangleGrid<T>& grid, Vec3<T> x, NearMemory<T>& memory,
                           int32_t mesh) {
  const Cell c = cell_of(grid, x);
  if ((c.i | c.j | c.k) < 0) return no_triangle(grid);
  const int32_t cell = cell_number(grid, c);
  const Rounding<T> rounding = rounding_at(grid, x);
  Nearest<T> best = no_triangle(grid);
  if (memory.mesh == mesh && memory.cell == cell) {
    const Vec3<T> way = x - memory.at;
    const T moved = square_root(dot(way, way));
    if (moved < memory.free) return no_triangle(grid);
    if (recall(grid, memory, moved, x, rounding, best)) return finish(grid, x, false, best);
  }
  const int32_t start = grid.cell_start[cell];
  if (start < 0) return nearest(grid, x);
  best = no_triangle(grid);
  search_list(grid, grid.entry_triangle + start, x, rounding, memory, best);
  memory.mesh = mesh;
  memory.cell = cell;
  best = finish(grid, x, false, best);
  if (best.triangle >= 0) memory.free = T(0);  // near, or inside
  return best;
}

/// The nearest point for one that lies about the thickness away, where the memory of the particle
/// helps but is not renewed: it is for where the particle goes. Inside tells as always.
template <class T>
WEFT_HD Nearest<T> nearest_about(const TriangleGrid<T>& grid, Vec3<T> x,
                                 const NearMemory<T>& memory, int32_t mesh) {
  const Cell c = cell_of(grid, x);
  if ((c.i | c.j | c.k) < 0) return no_triangle(grid);
  const int32_t cell = cell_number(grid, c), start = grid.cell_start[cell];
  if (start < 0) return no_triangle(grid);
  const Rounding<T> rounding = rounding_at(grid, x);
  const Nearest<T> none{-1, -1, false, {T(0), T(0), T(0)}, T(4) * grid.thickness * grid.thickness};
  Nearest<T> best = none;
  bool found = false;
  if (memory.mesh == mesh && memory.cell == cell) {
    const Vec3<T> way = x - memory.at;
    found = recall(grid, memory, square_root(dot(way, way)), x, rounding, best);
  }
  if (!found) {
    best = none;
    nearest_of_list(grid, grid.entry_triangle + start, x, rounding, best);
  }
  if (best.triangle < 0) return best;
  if (best.feature < 0) {
    const Vec3<T> n = face_normal(grid, best.triangle);
    const T height = dot(n, x - grid.corners[best.triangle].corner[0]);
    best.away = height * n;
    best.distance2 = height * height;
  }
  best.inside = grid.closed != 0 && lies_inside(grid, best);
  return best;
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
