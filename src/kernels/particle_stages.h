// The stages of a substep that look at single particles: constant forces, integration and pins.
// kernels/advance.h puts them in order.
#pragma once

#include "base/lanes.h"
#include "kernels/displacement.h"
#include "kernels/integrate.h"
#include "kernels/region.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Where a cloth's particles stand in the arrays of a part, less their own elements; or no_part.
template <class T>
WEFT_HD int shift_to(Part part, const ClothParams<T>& cloth) {
  return cloth.part[static_cast<int>(part)];
}

/// Where a moving pin is at the end of the substep. What stands in its place where no pin moves
/// (motion -1) has no meaning.
template <class T>
WEFT_HD Vec3<T> pin_target(const MovingPins<T>& pins, const StepParams<T>& step, int slot,
                           int motion) {
  const Vec3<T>* offset = pins.offset + int64_t(step.substep) * pins.motions;
  return load(pins.base, slot) + step.fraction * load(pins.glide, slot) +
         offset[motion < 0 ? 0 : motion];
}

template <class T>
struct ParticleStages {
  Simulation<T> sim;
  ParticleBuffers<T> p;
  StepParams<T> step;

  /// A sleeping cloth stands still: once its state is in every buffer, nothing is left to do.
  template <int N>
  WEFT_HD void rest(const ClothActivity<T>& activity, int i0, Lanes<N> lanes) const {
    if (step.substep < activity.settling) stand_still(i0, lanes);
  }

  template <int N>
  WEFT_HD void stand_still(int i0, Lanes<N> lanes) const {
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> x = load(p.x_in, i0 + l);
      store(p.x_out, i0 + l, x);
      store(p.d_out, i0 + l, step.position_form ? x : Vec3<T>{T(0), T(0), T(0)});
    });
  }

  template <int N>
  WEFT_HD void add_constant_forces(const ClothParams<T>& cloth, int i0, Lanes<N> lanes,
                                   LaneVec3<T, N>& force) const {
    const int from = i0 + shift_to(Part::forces, cloth);
    lanes.each([&](int l)
                   WEFT_LANE { force.set(l, force.get(l) + load(sim.forces.force, from + l)); });
  }

  /// The stage that turns forces into positions. Returns whether any particle of this call ended
  /// outside of the region.
  template <class Region, int N>
  WEFT_HD bool integrate(const ClothParams<T>& cloth, const Region& region, int i0, Lanes<N> lanes,
                         const LaneVec3<T, N>& force) const {
    if (step.update == Update::summed) {
      return integrate_displacement<false>(cloth, region, i0, lanes, force);
    }
    return integrate_otherwise(cloth, region, i0, lanes, force);
  }

  /// Where the displacement leads that springs have changed; pins are there already.
  template <class Region, int N>
  WEFT_HD bool take_displacement(const Region& within, int i0, Lanes<N> lanes) const {
    const ParticleBuffers<T> of = p;
    const T* inverse_mass = sim.inverse_mass;
    const Region region = within;
    return region.any_outside(lanes, [=](int l) WEFT_LANE {
      const int i = i0 + l;
      const Vec3<T> placed = load(of.x_out, i), to = load(of.x_in, i) + load(of.d_out, i);
      const Vec3<T> x = select(inverse_mass[i] > T(0), to, placed);
      store(of.x_out, i, x);
      return x;
    });
  }

  /// Puts the moving pins of a block there.
  template <int N>
  WEFT_HD void place_pins(int slot0, int i0, Lanes<N> lanes) const {
    lanes.each([&](int l) WEFT_LANE {
      const int motion = sim.pins.motion[slot0 + l];
      const Vec3<T> target = pin_target(sim.pins, step, slot0 + l, motion);
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

  /// Runs `next(i, d, a, w)`, which returns the new position, for every lane: last displacement,
  /// acceleration, inverse mass.
  template <bool Position, int N, class Region, class Next>
  WEFT_HD bool for_each_particle(const Region& region, int i0, Lanes<N> lanes,
                                 const LaneVec3<T, N>& force, Next next) const {
    return region.any_outside(lanes, [&](int l) WEFT_LANE {
      const T w = sim.inverse_mass[i0 + l];
      const Vec3<T> a = if_free(w, w * force.get(l) + step.gravity);
      return next(i0 + l, displacement<Position>(p, i0 + l), a, w);
    });
  }

  /// x' = x + d', and in the summed form d' is kept. A pinned particle has no displacement left.
  template <bool Position>
  WEFT_HD Vec3<T> move(int i, Vec3<T> d, T w) const {
    const Vec3<T> moved = if_free(w, d), x = load(p.x_in, i) + moved;
    store(p.x_out, i, x);
    if constexpr (!Position) store(p.d_out, i, moved);
    return x;
  }

  template <bool Position, class Region, int N>
  WEFT_HD bool integrate_displacement(const ClothParams<T>& cloth, const Region& region, int i0,
                                      Lanes<N> lanes, const LaneVec3<T, N>& force) const {
    const T c_dt = cloth.drag * step.dt;
    const Pace<T> pace = pace_of(step, cloth);
    switch (static_cast<Drag>(cloth.drag_model)) {
      case Drag::none:
        return for_each_particle<Position>(
            region, i0, lanes, force, [&](int i, Vec3<T> d, Vec3<T> a, T w) WEFT_LANE {
              return move<Position>(i, next_displacement(d, a, pace), w);
            });
      case Drag::central:
        return for_each_particle<Position>(
            region, i0, lanes, force, [&](int i, Vec3<T> d, Vec3<T> a, T w) WEFT_LANE {
              return move<Position>(i, next_displacement_central(d, a, c_dt * w, pace), w);
            });
      case Drag::lagged:
        return for_each_particle<Position>(
            region, i0, lanes, force, [&](int i, Vec3<T> d, Vec3<T> a, T w) WEFT_LANE {
              return move<Position>(i, next_displacement_lagged(d, a, c_dt * w, pace), w);
            });
    }
    return false;
  }

  /// The updates that no frame of the summed form enters. A function of its own on the host: it
  /// would be in every kernel otherwise.
  template <class Region, int N>
  WEFT_HD_COLD bool integrate_otherwise(const ClothParams<T>& cloth, const Region& region, int i0,
                                        Lanes<N> lanes, const LaneVec3<T, N>& force) const {
    if (step.update == Update::start) {
      integrate_start(cloth, i0, lanes, force);
      return false;
    }
    if (step.update == Update::acceleration) {
      return for_each_particle<false>(Everywhere{}, i0, lanes, force,
                                      [&](int i, Vec3<T>, Vec3<T> a, T) WEFT_LANE {
                                        store(p.x_out, i, a);
                                        return a;
                                      });
    }
    if (static_cast<Drag>(cloth.drag_model) != Drag::none) {
      return integrate_displacement<true>(cloth, region, i0, lanes, force);
    }
    const Pace<T> pace = pace_of(step, cloth);
    return region.any_outside(lanes, [&](int l) WEFT_LANE {
      const int i = i0 + l;
      const T w = sim.inverse_mass[i];
      const Vec3<T> x = load(p.x_in, i);
      const Vec3<T> a = if_free(w, w * force.get(l) + step.gravity);
      const Vec3<T> next = select(w > T(0), next_position(x, load(p.d_in, i), a, pace), x);
      store(p.x_out, i, next);
      return next;
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
      for_each_particle<true>(Everywhere{}, i0, lanes, force,
                              [&](int i, Vec3<T> d, Vec3<T> a, T w) WEFT_LANE {
                                const Vec3<T> x = load(p.x_in, i);
                                store(p.d_out, i, x - taylor_start(d, a, c_dt * w, step));
                                return x;
                              });
    } else {
      for_each_particle<false>(Everywhere{}, i0, lanes, force,
                               [&](int i, Vec3<T> d, Vec3<T> a, T w) WEFT_LANE {
                                 store(p.d_out, i, taylor_start(d, a, c_dt * w, step));
                                 return d;
                               });
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
