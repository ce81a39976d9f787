// The stages of a substep that know nothing of springs: forces on single particles, integration,
// colliders and pins. kernels/advance.h puts them in order.
#pragma once

#include "base/lanes.h"
#include "kernels/colliders.h"
#include "kernels/displacement.h"
#include "kernels/integrate.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T>
struct ParticleStages {
  Simulation<T> sim;
  ParticleBuffers<T> p;
  StepParams<T> step;

  template <int N>
  WEFT_HD void add_constant_forces(const ClothParams<T>& cloth, int i0, Lanes<N> lanes,
                                   LaneVec3<T, N>& force) const {
    const int from = i0 + cloth.force_offset;
    lanes.each([&](int l) WEFT_LANE { force.set(l, force.get(l) + load(sim.force, from + l)); });
  }

  /// The stage that turns forces into positions.
  template <int N>
  WEFT_HD void integrate(const ClothParams<T>& cloth, int i0, Lanes<N> lanes,
                         const LaneVec3<T, N>& force) const {
    if (step.update == Update::summed) {
      integrate_displacement<false>(cloth, i0, lanes, force);
    } else {
      integrate_otherwise(cloth, i0, lanes, force);
    }
  }

  /// Free particles against the cloth's colliders, one after the other.
  template <int N>
  WEFT_HD void collide(const ClothParams<T>& cloth, int i0, Lanes<N> lanes) const {
    collide_with(sim.colliders.spheres, ColliderShape::sphere, cloth, i0, lanes);
    collide_with(sim.colliders.planes, ColliderShape::plane, cloth, i0, lanes);
    collide_with(sim.colliders.capsules, ColliderShape::capsule, cloth, i0, lanes);
    collide_with(sim.colliders.cylinders, ColliderShape::cylinder, cloth, i0, lanes);
    collide_with(sim.colliders.boxes, ColliderShape::box, cloth, i0, lanes);
  }

  /// Puts the moving pins of a block where they are at the end of the substep.
  template <int N>
  WEFT_HD void place_pins(int slot0, int i0, Lanes<N> lanes) const {
    const Vec3<T>* offset = sim.pins.offset + int64_t(step.substep) * sim.pins.motions;
    lanes.each([&](int l) WEFT_LANE {
      const int motion = sim.pins.motion[slot0 + l];
      const Vec3<T> target = load(sim.pins.base, slot0 + l) +
                             step.fraction * load(sim.pins.glide, slot0 + l) +
                             offset[motion < 0 ? 0 : motion];
      const Vec3<T> x = select(motion < 0, load(p.x_out, i0 + l), target);
      const Vec3<T> d = x - load(p.x_in, i0 + l);
      store(p.x_out, i0 + l, x);
      if (!step.position_form) {
        store(p.d_out, i0 + l, select(motion < 0, load(p.d_out, i0 + l), d));
      }
    });
  }

 private:
  /// `v` for a free particle, 0 for a pinned one: selected, not multiplied, since a pin stays where
  /// it is even when its neighbours' positions are no longer finite.
  WEFT_HD static Vec3<T> if_free(T w, Vec3<T> v) {
    return select(w > T(0), v, Vec3<T>{T(0), T(0), T(0)});
  }

  /// Runs `next(i, d, a, w)` for every lane: last displacement, acceleration, inverse mass.
  template <bool Position, int N, class Next>
  WEFT_HD void for_each_particle(int i0, Lanes<N> lanes, const LaneVec3<T, N>& force,
                                 Next next) const {
    lanes.each([&](int l) WEFT_LANE {
      const T w = sim.inverse_mass[i0 + l];
      const Vec3<T> a = if_free(w, w * force.get(l) + step.gravity);
      next(i0 + l, displacement<Position>(p, i0 + l), a, w);
    });
  }

  /// x' = x + d', and in the summed form d' is kept. A pinned particle has no displacement left.
  template <bool Position>
  WEFT_HD void move(int i, Vec3<T> d, T w) const {
    const Vec3<T> moved = if_free(w, d);
    store(p.x_out, i, load(p.x_in, i) + moved);
    if constexpr (!Position) store(p.d_out, i, moved);
  }

  template <bool Position, int N>
  WEFT_HD void integrate_displacement(const ClothParams<T>& cloth, int i0, Lanes<N> lanes,
                                      const LaneVec3<T, N>& force) const {
    const T c_dt = cloth.drag * step.dt;
    switch (static_cast<Drag>(cloth.drag_model)) {
      case Drag::none:
        return for_each_particle<Position>(i0, lanes, force,
                                           [&](int i, Vec3<T> d, Vec3<T> a, T w) WEFT_LANE {
                                             move<Position>(i, next_displacement(d, a, step), w);
                                           });
      case Drag::central:
        return for_each_particle<Position>(
            i0, lanes, force, [&](int i, Vec3<T> d, Vec3<T> a, T w) WEFT_LANE {
              move<Position>(i, next_displacement_central(d, a, c_dt * w, step), w);
            });
      case Drag::lagged:
        return for_each_particle<Position>(
            i0, lanes, force, [&](int i, Vec3<T> d, Vec3<T> a, T w) WEFT_LANE {
              move<Position>(i, next_displacement_lagged(d, a, c_dt * w, step), w);
            });
    }
  }

  /// The updates that no frame of the summed form enters. A function of its own on the host: it
  /// would be in every kernel otherwise.
  template <int N>
  WEFT_HD_COLD void integrate_otherwise(const ClothParams<T>& cloth, int i0, Lanes<N> lanes,
                                        const LaneVec3<T, N>& force) const {
    if (step.update == Update::start) return integrate_start(cloth, i0, lanes, force);
    if (step.update == Update::acceleration) {
      return for_each_particle<false>(
          i0, lanes, force, [&](int i, Vec3<T>, Vec3<T> a, T) WEFT_LANE { store(p.x_out, i, a); });
    }
    if (static_cast<Drag>(cloth.drag_model) != Drag::none) {
      return integrate_displacement<true>(cloth, i0, lanes, force);
    }
    lanes.each([&](int l) WEFT_LANE {
      const int i = i0 + l;
      const T w = sim.inverse_mass[i];
      const Vec3<T> x = load(p.x_in, i);
      const Vec3<T> a = if_free(w, w * force.get(l) + step.gravity);
      store(p.x_out, i, select(w > T(0), next_position(x, load(p.d_in, i), a, step), x));
    });
  }

  /// Writes the displacement (summed form) or the previous position before the first step; a cloth
  /// that has begun already keeps what it has.
  template <int N>
  WEFT_HD void integrate_start(const ClothParams<T>& cloth, int i0, Lanes<N> lanes,
                               const LaneVec3<T, N>& force) const {
    const T c_dt = cloth.drag * step.dt;
    if (!cloth.starting) {
      lanes.each([&](int l) WEFT_LANE { store(p.d_out, i0 + l, load(p.d_in, i0 + l)); });
    } else if (step.position_form) {
      for_each_particle<true>(i0, lanes, force, [&](int i, Vec3<T> d, Vec3<T> a, T w) WEFT_LANE {
        store(p.d_out, i, load(p.x_in, i) - taylor_start(d, a, c_dt * w, step));
      });
    } else {
      for_each_particle<false>(i0, lanes, force, [&](int i, Vec3<T> d, Vec3<T> a, T w) WEFT_LANE {
        store(p.d_out, i, taylor_start(d, a, c_dt * w, step));
      });
    }
  }

  /// Blocks with no particle inside, which are most, pay for the test only.
  template <class Shape, int N>
  WEFT_HD void collide_with(const Shape* shapes, ColliderShape kind, const ClothParams<T>& cloth,
                            int i0, Lanes<N> lanes) const {
    const int k = static_cast<int>(kind);
    for (int s = cloth.collider_first[k]; s < cloth.collider_end[k]; ++s) {
      const Shape shape = shapes[s];
      const Vec3<T> by = step.time * shape.surface.velocity;
      const bool touched =
          lanes.any([&](int l) WEFT_LANE { return is_inside(shape, by, load(p.x_out, i0 + l)); });
      if (touched) push_out(shape, by, i0, lanes);
    }
  }

  /// Moves the free particles of a block out of a collider. The displacement takes the same
  /// correction as the position, not the difference of positions: that would round away what the
  /// summed form keeps. In the position form it follows from the positions.
  template <class Shape, int N>
  WEFT_HD_COLD void push_out(const Shape& shape, Vec3<T> by, int i0, Lanes<N> lanes) const {
    if (step.position_form) {
      push_out_as<true>(shape, by, i0, lanes);
    } else {
      push_out_as<false>(shape, by, i0, lanes);
    }
  }

  template <bool Position, class Shape, int N>
  WEFT_HD void push_out_as(const Shape& shape, Vec3<T> by, int i0, Lanes<N> lanes) const {
    const Vec3<T> carried = step.dt * shape.surface.velocity;
    const T friction = shape.surface.friction;
    lanes.each([&](int l) WEFT_LANE {
      const int i = i0 + l;
      const Vec3<T> x = load(p.x_out, i);
      const bool free = sim.inverse_mass[i] > T(0), inside = is_inside(shape, by, x);
      const bool hit = free & inside;
      const Vec3<T> push = select(hit, way_out(shape, by, x), Vec3<T>{T(0), T(0), T(0)});
      const Vec3<T> d = Position ? x - load(p.x_in, i) : load(p.d_out, i);
      const Vec3<T> slip = d - carried;
      const T share = impact_share(push, slip);
      const Vec3<T> drag = friction_displacement(push, slip, share, friction);
      store(p.x_out, i, x + (push + drag));
      if constexpr (!Position) store(p.d_out, i, d + (share * push + drag));
    });
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
