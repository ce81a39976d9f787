// The stage that keeps free particles out of the colliders of their cloth.
//
// A loop between lanes over the colliders that the block can touch, and for each a look at whether
// any particle is inside or fast. What is rare stands behind that look.
#pragma once

#include "base/lanes.h"
#include "kernels/contact.h"
#include "kernels/mesh_response.h"
#include "kernels/region.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Whether a block that stayed in its region has nothing to meet.
template <class T>
WEFT_HD bool meets_nothing(const Simulation<T>& sim, const ClothActivity<T>& activity, int block) {
  const int entries = activity.near_end[collider_shapes - 1] - activity.near_first[0];
  if (activity.nearness == Nearness::cloth || entries > 64) return entries == 0;
  return sim.reach[block].mask == 0;
}

/// Where the list of a block's colliders holds: the block's own, or its cloth's.
template <class T>
WEFT_HD Region<T> region_of(const Simulation<T>& sim, const ClothParams<T>& cloth,
                            const ClothActivity<T>& activity, int block, int i0) {
  const bool by_block = activity.nearness == Nearness::block;
  return {by_block ? sim.reach[block].low : activity.low,
          by_block ? sim.reach[block].high : activity.high, cloth.end - i0};
}

/// What a pass meets: everything on the host; a GPU meets meshes, which need many registers, in a
/// pass of their own.
enum class Meets : uint8_t { all, shapes, meshes };

template <class T, Meets what = Meets::all>
struct CollideStage {
  const Simulation<T>& sim;
  const ParticleBuffers<T>& p;
  const StepParams<T>& step;

  /// `every`: the block meets all colliders, not only those of its list. So it does, from there on,
  /// when a collider pushes a particle out of the region of the list. A function of its own on the
  /// host, for all kinds of springs.
  template <int N>
  WEFT_HD_COLD void operator()(const ClothParams<T>& cloth, const ClothActivity<T>& activity,
                               bool every, const Region<T>& region, int block, int i0,
                               Lanes<N> lanes) const {
    const uint64_t mask =
        activity.nearness == Nearness::block ? sim.reach[block].mask : ~uint64_t(0);
    const Walk walk{cloth, activity, region, mask};
    const Colliders<T>& c = sim.colliders;
    if constexpr (what != Meets::meshes) {
      every = meet_all(c.spheres, walk, ColliderShape::sphere, every, i0, lanes);
      every = meet_all(c.planes, walk, ColliderShape::plane, every, i0, lanes);
      every = meet_all(c.capsules, walk, ColliderShape::capsule, every, i0, lanes);
      every = meet_all(c.cylinders, walk, ColliderShape::cylinder, every, i0, lanes);
      every = meet_all(c.boxes, walk, ColliderShape::box, every, i0, lanes);
    }
    if constexpr (what != Meets::shapes) {
      meet_all(c.meshes, walk, ColliderShape::mesh, every, i0, lanes);
    }
  }

  /// Whether any particle is outside of the region now.
  template <int N>
  WEFT_HD bool has_left(const Region<T>& region, int i0, Lanes<N> lanes) const {
    const Vec3Array<T> x = p.x_out;
    return region.any_particle_outside(lanes, [=](int l) WEFT_LANE { return load(x, i0 + l); });
  }

 private:
  struct Walk {
    const ClothParams<T>& cloth;
    const ClothActivity<T>& activity;
    const Region<T>& region;
    uint64_t mask;  ///< of the first 64 entries of the list
  };

  /// The colliders of one shape, in their order. Returns whether all are to be met from here on.
  template <class Shape, int N>
  WEFT_HD bool meet_all(const Shape* all, const Walk& walk, ColliderShape kind, bool every, int i0,
                        Lanes<N> lanes) const {
    const int k = static_cast<int>(kind);
    const Shape* shapes = all + walk.cloth.collider_first[k];
    const int count = walk.cloth.end - i0;
    int next = 0;
    for (int j = walk.activity.near_first[k]; !every && j < walk.activity.near_end[k]; ++j) {
      const int bit = j - walk.activity.near_first[0];
      if (bit < 64 && ((walk.mask >> bit) & 1) == 0) continue;
      const int index = sim.colliders.near[j];
      if (!concerns(shapes[index], walk.region, i0, lanes)) {
        next = index + 1;
        continue;
      }
      if (meet(shapes[index], count, i0, lanes)) every = has_left(walk.region, i0, lanes);
      next = index + 1;
    }
    for (int index = next; every && index < walk.cloth.collider_count[k]; ++index) {
      meet(shapes[index], count, i0, lanes);
    }
    return every;
  }

  /// Whether a block that is in its region may have to do with a collider: `meet` says for sure. Of
  /// one that turns this looks at where it is now, with something around it for rounding and, where
  /// a particle would be fast, for the turn.
  template <class Shape, int N>
  WEFT_HD bool concerns(const Shape& shape, const Region<T>& region, int i0, Lanes<N> lanes) const {
    return shape.surface.turn < 0 || concerns_turning(shape, region, i0, lanes);
  }
  template <int N>
  WEFT_HD bool concerns(const MeshCollider<T>&, const Region<T>&, int, Lanes<N>) const {
    return true;
  }
  template <class Shape, int N>
  WEFT_HD_COLD bool concerns_turning(const Shape& shape, const Region<T>& region, int i0,
                                     Lanes<N> lanes) const {
    const Turned<T> before = turned(sim.colliders, shape.surface, step, 1);
    const Turned<T> now = turned(sim.colliders, shape.surface, step, 0);
    const Vec3<T> center = now.pivot + now.by, low = region.low - center;
    const Vec3<T> high = region.high - center;
    const Vec3<T> far{larger(magnitude(low.x), magnitude(high.x)),
                      larger(magnitude(low.y), magnitude(high.y)),
                      larger(magnitude(low.z), magnitude(high.z))};
    const T reach = span_of(far), size = size_of(shape);
    const T rounding =
        T(8) * (rounding_of(region.low) + rounding_of(region.high) + rounding_of(center) +
                rounding_of(now.pivot) + rounding_of(Vec3<T>{reach, size, T(0)}));
    const T turn = turn_between(before, now) * reach;
    // In the position form a particle is looked at where it was before, too.
    const T margin = step.position_form ? rounding + T(2) * turn : rounding;
    Shape around = grown(at_present(now, shape), margin);
    around.surface.sweep = shape.surface.sweep - (turn + rounding);
    if (IsSwept<Shape>::value && !(around.surface.sweep > T(0))) return true;
    const Shifted<T> none{{T(0), T(0), T(0)}}, ago{before.by - now.by};
    return step.position_form ? touches<true>(around, ago, none, region.count, i0, lanes)
                              : touches<false>(around, ago, none, region.count, i0, lanes);
  }

  /// Each returns whether it has changed anything, or may have. `count`: as in Region.
  template <class Shape, int N>
  WEFT_HD bool meet(const Shape& shape, int count, int i0, Lanes<N> lanes) const {
    if (shape.surface.turn >= 0) return meet_turning(shape, count, i0, lanes);
    return meet_placed(shape, shifted(shape.surface, step, 1), shifted(shape.surface, step, 0),
                       count, i0, lanes);
  }
  template <class Shape, int N>
  WEFT_HD_COLD bool meet_turning(const Shape& shape, int count, int i0, Lanes<N> lanes) const {
    return meet_placed(shape, turned(sim.colliders, shape.surface, step, 1),
                       turned(sim.colliders, shape.surface, step, 0), count, i0, lanes);
  }
  template <class Shape, class Placement, int N>
  WEFT_HD bool meet_placed(const Shape& shape, const Placement& before, const Placement& now,
                           int count, int i0, Lanes<N> lanes) const {
    const bool touched = step.position_form ? touches<true>(shape, before, now, count, i0, lanes)
                                            : touches<false>(shape, before, now, count, i0, lanes);
    if (touched) respond(shape, before, now, i0, lanes);
    return touched;
  }

  template <bool Position, class Shape, class Placement, int N>
  WEFT_HD bool touches(const Shape& shape, const Placement& before, const Placement& now, int count,
                       int i0, Lanes<N> lanes) const {
    const Concern<T, Position, Shape, Placement> concern{p, shape, before, now};
    return lanes.any([&](int l) WEFT_LANE { return (l < count) & concern(i0 + l); });
  }

  template <int N>
  WEFT_HD bool meet(const MeshCollider<T>& mesh, int, int i0, Lanes<N> lanes) const {
    if (mesh.surface.turn >= 0) {
      const Turned<T> before = turned(sim.colliders, mesh.surface, step, 1);
      return meet_mesh(mesh, before, turned(sim.colliders, mesh.surface, step, 0), i0, lanes);
    }
    return meet_mesh(mesh, shifted(mesh.surface, step, 1), shifted(mesh.surface, step, 0), i0,
                     lanes);
  }
  template <class Placement, int N>
  WEFT_HD bool meet_mesh(const MeshCollider<T>& mesh, const Placement& before, const Placement& now,
                         int i0, Lanes<N> lanes) const {
    return step.position_form ? meet_triangles<true>(mesh, before, now, i0, lanes)
                              : meet_triangles<false>(mesh, before, now, i0, lanes);
  }
  /// All lanes find their cells; then those that have triangles near them, or are fast, are looked
  /// at one by one: no two have the same list.
  template <bool Position, class Placement, int N>
  WEFT_HD_COLD bool meet_triangles(const MeshCollider<T>& mesh, const Placement& before,
                                   const Placement& now, int i0, Lanes<N> lanes) const {
    const MeshEnds<T, Placement> ends{p.x_in, p.x_out, mesh.rotation, mesh.translate, before, now};
    const CellFinder<T> cells = cells_of(mesh.grid);
    const T short2 = T(0.25) * mesh.grid.thickness * mesh.grid.thickness;
    LaneVec3<T, N> from, to, led;
    int32_t cell[N], brick[N];
    if constexpr (Position) {
      const Vec3Array<T> previous = p.d_in;
      lanes.each([&](int l) WEFT_LANE { led.set(l, ends.way_before(previous, i0 + l)); });
    }
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
      if constexpr (Position) {
        any |= take_back(mesh, now, led.get(l), from.get(l), to, cells, cell[l], brick[l], i0, l);
      }
      if (cell[l] == no_cell) return;
      if (cell[l] != is_fast && !is_occupied(mesh.grid, brick[l])) return;
      const MeshContact<T> contact = mesh_contact(mesh.grid, from.get(l), to.get(l),
                                                  sim.near_memory[i0 + l], number, Position);
      if (!contact.hit) return;
      any = true;
      wanted.hit[l] = contact.stopped ? T(2) : contact.slides ? T(3) : T(1);
      wanted.push.set(l, contact.to - to.get(l));
      wanted.normal.set(l, contact.normal);
      const StartOnMesh<T> start =
          start_on_mesh(mesh.grid, from.get(l), contact, sim.near_memory[i0 + l], number);
      wanted.start.set(l, start.normal);
      wanted.start_depth[l] = start.depth;
    });
    if (!any) return false;
    const MeshResponse<T, Position, Placement, N> response{
        sim.inverse_mass, p, mesh.rotation, mesh.surface.friction, before, now, pushed()};
    lanes.each([&](int l) WEFT_LANE { response(l, i0 + l, wanted); });
    return true;
  }

  /// The position form goes on with the way out of deep inside: it is taken back. Returns whether.
  template <class Placement, int N>
  WEFT_HD bool take_back(const MeshCollider<T>& mesh, const Placement& now, Vec3<T> way_before,
                         Vec3<T> from, LaneVec3<T, N>& to, const CellFinder<T>& cells,
                         int32_t& cell, int32_t& brick, int i0, int l) const {
    const T little = T(0.05) * mesh.grid.thickness;
    const bool free = sim.inverse_mass[i0 + l] > T(0);
    if (!free || !(magnitude2(way_before) > little * little)) return false;
    const int32_t number = 1 + static_cast<int32_t>(&mesh - sim.colliders.meshes);
    const Vec3<T> by =
        step.ratio * thrown(mesh.grid, from, way_before, sim.near_memory[i0 + l], number);
    if (!(magnitude2(by) > T(0))) return false;
    const Vec3<T> end = to.get(l) - by;
    to.set(l, end);
    store(p.x_out, i0 + l, load(p.x_out, i0 + l) - turned(now, mesh.rotation * by));
    const CellAndBrick at = cells(end);
    cell = is_long(mesh.grid, end - from) ? is_fast : at.cell;
    brick = at.brick;
    return true;
  }

  WEFT_HD T pushed() const { return sim.contacts.state != nullptr ? T(1) : T(0); }

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
    const Contact<T, Position, Shape, Placement> contact{
        sim.inverse_mass, p, shape, before, now, step.ratio, pushed()};
    if constexpr (Position) {
      lanes.each([&](int l) WEFT_LANE { contact.take_back_throw(i0 + l); });
    }
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
