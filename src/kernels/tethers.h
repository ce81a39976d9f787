// Tethers: a particle keeps within a distance of its pin (long-range attachments; Kim, Chentanez
// and Müller 2012), one-sided.
#pragma once

#include "kernels/particle_stages.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// What takes a particle, `away` from its pin and |away| = r > L, back towards it:
///
///     dx = -w/(w + a) (r - L) away/r,    a = compliance/dt^2
///
/// `share` is w/(w + a): 1 is the hard clamp, less one iteration of XPBD from lambda = 0 (Macklin,
/// Müller and Chentanez 2016, eq. 18) with a pin of infinite mass.
template <class T>
WEFT_HD Vec3<T> tether_correction(Vec3<T> away, T r, T limit, T share) {
  return (share * (limit / r - T(1))) * away;
}

/// The part of a hard tether's correction that the displacement takes: no more than the substep
/// went away from the pin (`motion`, relative to it). Who was within the limit before takes all of
/// it; who was not, as at a start outside or after a new pin, is moved without speed.
template <class T>
WEFT_HD Vec3<T> without_speed(Vec3<T> correction, Vec3<T> away, Vec3<T> motion) {
  const T square = dot(away, away), outward = dot(motion, away);
  const T taken = -dot(correction, away);  // both times |away|
  const bool all = outward >= taken;
  const T some = outward > T(0) ? -outward / (square > T(0) ? square : T(1)) : T(0);
  return select(all, correction, some * away);
}

/// Where a pin is at the end of the substep, whether it moves or not.
template <class T>
WEFT_HD Vec3<T> pin_position(const ParticleBuffers<T>& p, const MovingPins<T>& pins,
                             const StepParams<T>& step, int pin) {
  const Vec3<T> still = load(p.x_in, pin);
  if (pins.of_block == nullptr) return still;
  const int block = pins.of_block[pin / block_size];
  const int slot = (block < 0 ? 0 : block) * block_size + pin % block_size;
  const int motion = block < 0 ? -1 : pins.motion[slot];
  return select(motion < 0, still, pin_target(pins, step, slot, motion));
}

/// The stage: a correction moves the particle and is part of its displacement. `left`: whether any
/// particle is outside of the region before it; returned is whether one is behind it. One function
/// on the host for all kinds of springs.
template <class T, class Region, int N>
WEFT_HD_COLD bool keep_tethered(const ParticleStages<T>& stages, const ClothParams<T>& cloth,
                                const Region& within, bool left, int i0, Lanes<N> lanes) {
  // Copies: g++ vectorises no loop that reads through references.
  const ParticleBuffers<T> p = stages.p;
  const Tethers<T> tethers = stages.sim.tethers;
  const MovingPins<T> pins = stages.sim.pins;
  const StepParams<T> step = stages.step;
  const int t0 = i0 + shift_to(Part::tethers, cloth);
  const int common = tethers.common[t0 / block_size];
  LaneVec3<T, N> away;  // from the pin where it is at the end of the substep
  if (common != several_pins) {
    const Vec3<T> pin = pin_position(p, pins, step, common);
    lanes.each([&](int l) WEFT_LANE { away.set(l, load(p.x_out, i0 + l) - pin); });
  } else {
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> pin = pin_position(p, pins, step, tethers.pin[t0 + l]);
      away.set(l, load(p.x_out, i0 + l) - pin);
    });
  }
  const auto beyond = [=](int l, Vec3<T> a) WEFT_LANE {
    return dot(a, a) > tethers.limit[t0 + l] * tethers.limit[t0 + l];
  };
  if (!lanes.any([&](int l) WEFT_LANE { return beyond(l, away.get(l)); })) return left;
  const T give = cloth.part_number[static_cast<int>(Part::tethers)] / (step.dt * step.dt);
  const T* inverse_mass = stages.sim.inverse_mass;
  const Region region = within;
  LaneVec3<T, N> by;
  lanes.each([&](int l) WEFT_LANE {
    const Vec3<T> a = away.get(l);
    const T w = inverse_mass[i0 + l], r = square_root(beyond(l, a) ? dot(a, a) : T(1));
    by.set(l, tether_correction(a, r, tethers.limit[t0 + l], w / (w + give)));
  });
  if (!step.position_form) {
    const bool hard = !(give > T(0));
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> a = away.get(l), d = load(p.d_out, i0 + l), whole = by.get(l);
      const Vec3<T> pin_end = load(p.x_out, i0 + l) - a;
      const Vec3<T> of_pin = pin_end - load(p.x_in, tethers.pin[t0 + l]);
      const Vec3<T> taken = hard ? without_speed(whole, a, d - of_pin) : whole;
      store(p.d_out, i0 + l, select(beyond(l, a), d + taken, d));
    });
  }
  return region.any_outside(lanes, [&](int l) WEFT_LANE {
    const Vec3<T> x = load(p.x_out, i0 + l);
    const Vec3<T> kept = select(beyond(l, away.get(l)), x + by.get(l), x);
    store(p.x_out, i0 + l, kept);
    return kept;
  });
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
