// The response of one particle to a triangle mesh: to the thickness, with Coulomb friction.
#pragma once

#include "kernels/contact.h"
#include "kernels/mesh_contact.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Where a particle comes from and goes to in the mesh's own frame.
template <class T, class Placement>
struct MeshEnds {
  Vec3Array<T> x_in, x_out;
  Mat3<T> rotation;
  Vec3<T> translate;
  Placement before, now;

  WEFT_HD Vec3<T> start(int i) const {
    return back(rotation, at_start(before, load(x_in, i)) - translate);
  }
  /// Of the substep before, relative to the mesh, which is taken to have moved as it does now.
  WEFT_HD Vec3<T> way_before(Vec3Array<T> previous, int i) const {
    const Vec3<T> x0 = load(x_in, i), along = carried(before, now, x0);
    const Vec3<T> from = load(previous, i) + along;
    return back(rotation, at_start(before, x0) - at_start(before, from));
  }
  WEFT_HD Vec3<T> end(int i) const {
    return back(rotation, at_start(now, load(x_out, i)) - translate);
  }
};

constexpr int32_t no_cell = -1, is_fast = -2;
/// Number of the cell of a point and of its brick.
struct CellAndBrick {
  int32_t cell, brick;
};
/// By arithmetic alone, for all lanes at once.
template <class T>
struct CellFinder {
  Vec3<T> low;
  T inverse_size;
  int32_t along_x, along_y, along_z, bricks_x, bricks_y;

  WEFT_HD CellAndBrick operator()(Vec3<T> x) const {
    const Vec3<T> f = inverse_size * (x - low);
    const bool in_x = (f.x >= T(0)) & (f.x < T(along_x));
    const bool in_y = (f.y >= T(0)) & (f.y < T(along_y));
    const bool in_z = (f.z >= T(0)) & (f.z < T(along_z));
    const bool in = in_x & in_y & in_z;
    // What is outside must not be converted: it may not fit.
    const int i = int(in ? f.x : T(0)), j = int(in ? f.y : T(0)), k = int(in ? f.z : T(0));
    const int brick = ((k / brick_edge) * bricks_y + j / brick_edge) * bricks_x + i / brick_edge;
    return {in ? (k * along_y + j) * along_x + i : no_cell, brick};
  }
};
template <class T>
WEFT_HD CellFinder<T> cells_of(const TriangleGrid<T>& grid) {
  return {grid.low,      grid.inverse_cell_size, grid.cells[0],        grid.cells[1],
          grid.cells[2], bricks_along(grid, 0),  bricks_along(grid, 1)};
}

/// What the triangles want of the lanes of a block.
template <class T, int N>
struct MeshPushes {
  LaneVec3<T, N> push, normal;  ///< in the mesh's own frame
  LaneVec3<T, N> start;         ///< normal where the substep began, or as `normal`
  T start_depth[N];             ///< m below the thickness there
  T hit[N];  ///< 0: nothing; 1: goes to the thickness; 2: was stopped on the way;
             ///< 3: slid far
};

/// Vectorised over the lanes. `Position`: the displacement is kept as the previous position.
template <class T, bool Position, class Placement, int N>
struct MeshResponse {
  const T* inverse_mass;
  ParticleBuffers<T> p;
  Mat3<T> rotation;
  T friction;
  Placement before, now;
  T pushed;  ///< as in Contact

  /// Along the normal where the substep began, as Contact::push_out; along that where it ended if
  /// the two are not known to go together. No such push may add to the kinetic energy: a mesh need
  /// not be convex.
  WEFT_HD void operator()(int l, int i, const MeshPushes<T, N>& wanted) const {
    const Vec3<T> x = load(p.x_out, i);
    const bool hit = (wanted.hit[l] > T(0)) & (inverse_mass[i] > T(0));
    const Vec3<T> d = Position ? x - load(p.x_in, i) : load(p.d_out, i);
    const Vec3<T> x0 = load(p.x_in, i), along = carried(before, now, x0), slip = d - along;
    // The correction is turned, not the position: nothing is lost far from the mesh's origin.
    const Vec3<T> whole = wanted.push.get(l), end = wanted.normal.get(l);
    const Vec3<T> start = wanted.start.get(l);
    const Vec3<T> start_now = turned(before, rotation * start);
    const Vec3<T> bend = turned(now, rotation * end) - start_now;
    const T cosine = T(1) - T(0.5) * magnitude2(bend);
    const T depth = dot(whole, end), start_depth = wanted.start_depth[l];
    const T per_depth = T(1) / (cosine < T(0.5) ? T(1) : cosine);
    const T by_others = Position ? T(0) : pushed_into(pushed, x0, x, d, start_now);
    const T made = per_depth * larger(T(0), depth - larger(T(0), start_depth) - by_others);
    const bool adds = made > T(-2) * dot(slip, start_now);
    const bool flat = !(magnitude2(bend) > T(0));
    const bool slid = wanted.hit[l] > T(2);
    const bool from_start = slid | !(flat | adds | (cosine < T(0.5)));
    const Vec3<T> normal = select(from_start, start_now, turned(now, rotation * end));
    const Vec3<T> push =
        select(from_start, (per_depth * depth) * start_now, turned(now, rotation * whole));
    const T across = dot(slip, normal), closing = larger(T(0), -across);
    const T moved = from_start ? made : closing;
    const Vec3<T> sliding = slip - across * normal;
    const T most = friction * moved;
    const T held = part_held(sliding, most);
    const Vec3<T> drag = (-held) * sliding;
    // What lay on the surface and sticks there is where it was, to the last bit.
    const T bent = from_start ? dot(sliding, bend) : T(0);
    const T again = (held - T(0.5) * held * held) * bent;  // below a surface that is curved
    const T above = from_start ? magnitude(start_depth) - magnitude(bent)
                               : magnitude(closing - dot(push, normal));
    const bool lay = above <= rounding_of(x);
    const bool stopped = (wanted.hit[l] > T(1)) & !slid;
    const bool holds = (magnitude2(sliding) <= most * most) & (most > T(0));
    const bool sticks = hit & lay & holds & !stopped;
    // Of what was stopped on the way, only the velocity is braked.
    const Vec3<T> none{T(0), T(0), T(0)};
    const Vec3<T> by = push + select(stopped, none, again * normal + drag);
    store(p.x_out, i, select(sticks, x0 + along, x + select(hit, by, none)));
    if constexpr (!Position) {
      const Vec3<T> braked = d + select(hit, (moved + again) * normal + drag, none);
      store(p.d_out, i, select(sticks, along, braked));
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
