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
  WEFT_HD Vec3<T> end(int i) const {
    return back(rotation, at_start(now, load(x_out, i)) - translate);
  }
};

/// Number of the cell of a point and of its brick.
struct CellAndBrick {
  int32_t cell, brick;
};
constexpr int32_t no_cell = -1, is_fast = -2;
/// By arithmetic alone, for all lanes at once.
template <class T>
struct CellFinder {
  Vec3<T> low;
  T inverse_size;
  int32_t along_x, along_y, along_z, bricks_x, bricks_y;

  WEFT_HD CellAndBrick find(Vec3<T> x) const {
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

/// `Position`: the displacement is kept as the previous position.
template <class T, bool Position, class Placement>
struct MeshResponse {
  const T* inverse_mass;
  ParticleBuffers<T> p;
  NearMemory<T>* memory;
  int32_t number;  ///< of the collider, in `memory`
  const MeshCollider<T>& mesh;
  Placement before, now;

  WEFT_HD void respond(int i, Vec3<T> p0, Vec3<T> p1) const {
    if (!(inverse_mass[i] > T(0))) return;
    const Vec3<T> x = load(p.x_out, i);
    const MeshContact<T> contact = mesh_contact(mesh.grid, p0, p1, memory[i], number);
    if (!contact.hit) return;
    // The correction is turned, not the position: nothing is lost far from the mesh's origin.
    const Vec3<T> push = turned(now, mesh.rotation * (contact.to - p1));
    const Vec3<T> normal = turned(now, mesh.rotation * contact.normal);
    const Vec3<T> d = displacement_of(i, x), slip = d - carried(before, now, x);
    const T against = -dot(slip, normal), closing = against > T(0) ? against : T(0);
    const Vec3<T> along = slip + against * normal;
    const Vec3<T> drag = friction_against(along, mesh.surface.friction * closing);
    store(p.x_out, i, contact.stopped ? x + push : x + (push + drag));
    if constexpr (!Position) store(p.d_out, i, d + (closing * normal + drag));
  }

 private:
  WEFT_HD Vec3<T> displacement_of(int i, Vec3<T> x) const {
    if constexpr (Position) {
      return x - load(p.x_in, i);
    } else {
      return load(p.d_out, i);
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
