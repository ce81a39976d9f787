// The stage that keeps free particles out of the colliders of their cloth.
//
// A loop between lanes over the colliders that the block can touch, and for each a look at whether
// any particle is inside or fast. What is rare stands behind that look.
#pragma once

#include "base/lanes.h"
#include "kernels/contact.h"
#include "kernels/mesh_response.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Which colliders a block meets in this substep: entries of a list per shape.
struct Candidates {
  const int32_t* list;
  const int *first, *end;  ///< by shape
  uint64_t mask;           ///< of the first 64 entries
};

/// Whether a block that stayed in its region has nothing to meet.
template <class T>
WEFT_HD bool meets_nothing(const Simulation<T>& sim, const ClothActivity<T>& activity, int block) {
  const int entries = activity.near_end[collider_shapes - 1] - activity.near_first[0];
  if (activity.nearness == Nearness::cloth || entries > 64) return entries == 0;
  return sim.reach[block].mask == 0;
}

template <class T>
struct CollideStage {
  const Simulation<T>& sim;
  const ParticleBuffers<T>& p;
  const StepParams<T>& step;

  /// `every`: the block meets all colliders, not only those of its list. A function of its own on
  /// the host, for all kinds of springs.
  template <int N>
  WEFT_HD_COLD void operator()(const ClothParams<T>& cloth, const ClothActivity<T>& activity,
                               bool every, int block, int i0, Lanes<N> lanes) const {
    const int none[collider_shapes] = {};
    Candidates with{sim.colliders.every, none, cloth.collider_count, ~uint64_t(0)};
    if (!every) {
      const uint64_t mask =
          activity.nearness == Nearness::block ? sim.reach[block].mask : ~uint64_t(0);
      with = {sim.colliders.near, activity.near_first, activity.near_end, mask};
    }
    const Colliders<T>& c = sim.colliders;
    const int* of = cloth.collider_first;
    meet_all(c.spheres + of[0], with, ColliderShape::sphere, i0, lanes);
    meet_all(c.planes + of[1], with, ColliderShape::plane, i0, lanes);
    meet_all(c.capsules + of[2], with, ColliderShape::capsule, i0, lanes);
    meet_all(c.cylinders + of[3], with, ColliderShape::cylinder, i0, lanes);
    meet_all(c.boxes + of[4], with, ColliderShape::box, i0, lanes);
    meet_all(c.meshes + of[5], with, ColliderShape::mesh, i0, lanes);
  }

 private:
  template <class Shape, int N>
  WEFT_HD void meet_all(const Shape* shapes, const Candidates& with, ColliderShape kind, int i0,
                        Lanes<N> lanes) const {
    const int k = static_cast<int>(kind);
    for (int j = with.first[k]; j < with.end[k]; ++j) {
      const int bit = j - with.first[0];
      if (bit < 64 && ((with.mask >> bit) & 1) == 0) continue;
      meet(shapes[with.list[j]], i0, lanes);
    }
  }

  template <class Shape, int N>
  WEFT_HD void meet(const Shape shape, int i0, Lanes<N> lanes) const {
    if (shape.surface.turn >= 0) {
      const Turned<T> before = turned(sim.colliders, shape.surface, step, 1);
      return respond(shape, before, turned(sim.colliders, shape.surface, step, 0), i0, lanes);
    }
    const Shifted<T> before = shifted(shape.surface, step, 1);
    const Shifted<T> now = shifted(shape.surface, step, 0);
    const Concern<Shape, T> concern{p.x_in, p.x_out, shape, before.by, now.by};
    const bool touched = lanes.any([&](int l) WEFT_LANE { return concern(i0 + l); });
    if (touched) respond(shape, before, now, i0, lanes);
  }

  template <int N>
  WEFT_HD void meet(const MeshCollider<T>& mesh, int i0, Lanes<N> lanes) const {
    if (mesh.surface.turn >= 0) {
      const Turned<T> before = turned(sim.colliders, mesh.surface, step, 1);
      return meet_mesh(mesh, before, turned(sim.colliders, mesh.surface, step, 0), i0, lanes);
    }
    meet_mesh(mesh, shifted(mesh.surface, step, 1), shifted(mesh.surface, step, 0), i0, lanes);
  }
  template <class Placement, int N>
  WEFT_HD void meet_mesh(const MeshCollider<T>& mesh, const Placement& before, const Placement& now,
                         int i0, Lanes<N> lanes) const {
    if (step.position_form) {
      meet_triangles<true>(mesh, before, now, i0, lanes);
    } else {
      meet_triangles<false>(mesh, before, now, i0, lanes);
    }
  }
  /// All lanes find their cells; then those that have triangles near them, or are fast, are looked
  /// at one by one: no two have the same list.
  template <bool Position, class Placement, int N>
  WEFT_HD_COLD void meet_triangles(const MeshCollider<T>& mesh, const Placement& before,
                                   const Placement& now, int i0, Lanes<N> lanes) const {
    const MeshEnds<T, Placement> ends{p.x_in, p.x_out, mesh.rotation, mesh.translate, before, now};
    const CellFinder<T> cells = cells_of(mesh.grid);
    const T short2 = T(0.25) * mesh.grid.thickness * mesh.grid.thickness;
    LaneVec3<T, N> from, to;
    int32_t cell[N], brick[N];
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> p0 = ends.start(i0 + l), p1 = ends.end(i0 + l);
      from.set(l, p0);
      to.set(l, p1);
      const CellAndBrick at = cells(p1);
      cell[l] = magnitude2(p1 - p0) > short2 ? is_fast : at.cell;
      brick[l] = at.brick;
    });
    const int32_t number = 1 + static_cast<int32_t>(&mesh - sim.colliders.meshes);
    MeshPushes<T, N> wanted;
    bool any = false;
    lanes.each_alone([&](int l) {
      wanted.hit[l] = T(0);
      if (cell[l] == no_cell) return;
      if (cell[l] != is_fast && !is_occupied(mesh.grid, brick[l])) return;
      const MeshContact<T> contact =
          mesh_contact(mesh.grid, from.get(l), to.get(l), sim.near_memory[i0 + l], number);
      if (!contact.hit) return;
      any = true;
      wanted.hit[l] = contact.stopped ? T(2) : T(1);
      wanted.push.set(l, contact.to - to.get(l));
      wanted.normal.set(l, contact.normal);
    });
    if (!any) return;
    const MeshResponse<T, Position, Placement, N> response{
        sim.inverse_mass, p, mesh.rotation, mesh.surface.friction, before, now};
    lanes.each([&](int l) WEFT_LANE { response(l, i0 + l, wanted); });
  }

  /// Moves the free particles of a block out of a collider. A function of its own on the host: most
  /// blocks touch nothing.
  template <class Shape, class Placement, int N>
  WEFT_HD_COLD void respond(const Shape& shape, const Placement& before, const Placement& now,
                            int i0, Lanes<N> lanes) const {
    if (step.position_form) {
      respond_as<true>(shape, before, now, i0, lanes);
    } else {
      respond_as<false>(shape, before, now, i0, lanes);
    }
  }
  template <bool Position, class Shape, class Placement, int N>
  WEFT_HD void respond_as(const Shape& shape, const Placement& before, const Placement& now, int i0,
                          Lanes<N> lanes) const {
    const Contact<T, Position, Shape, Placement> contact{sim.inverse_mass, p, shape, before, now};
    if constexpr (IsSwept<Shape>::value) {
      const bool fast = lanes.any([&](int l) WEFT_LANE { return contact.is_fast(i0 + l); });
      if (fast) stop_at_entry(contact, i0, lanes);
    }
    lanes.each([&](int l) WEFT_LANE { contact.push_out(i0 + l); });
  }
  /// Fast particles are few: not worth a vector loop of their own.
  template <class Contact, int N>
  WEFT_HD_COLD static void stop_at_entry(const Contact& contact, int i0, Lanes<N> lanes) {
    lanes.each_alone([&](int l) { contact.stop_at_entry(i0 + l); });
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
