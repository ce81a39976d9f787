// What touching particles do to each other, after they were counted (touch.h).
#pragma once

#include "kernels/touch.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Unit vector of two particles at one place, away from the one of higher rank.
template <class T>
WEFT_HD Vec3<T> direction_of_ranks(uint32_t a, uint32_t b) {
  const uint32_t low = a < b ? a : b, high = a < b ? b : a;
  const uint32_t mixed = (low * 0x9e3779b1u ^ high) * 0x85ebca6bu;
  const uint32_t axis = (mixed >> 16) % 3u;
  const T sign = ((mixed >> 9 & 1u) != 0) != (a < b) ? T(1) : T(-1);
  return {axis == 0 ? sign : T(0), axis == 1 ? sign : T(0), axis == 2 ? sign : T(0)};
}

/// An overlap counts as the weight of what lies above, by what all passes push of it: as far as
/// gravity moves a particle by in a substep, times this. In a heap at rest the overlap of layers
/// that lie in each other's hollows is 2 to 3 times as many of these moves as layers lie above.
constexpr int most_weights = 40;

/// What one particle does to another.
template <class T>
struct PairPush {
  Vec3<T> push, brake;
  T impulse;      ///< of the pair in this substep so far; below zero: the two did not touch
  int32_t wakes;  ///< 1: it would wake the other
};

/// What the partners of each particle do to it, into memory of its own: the others still read its
/// position.
template <class T, bool Position>
struct PushApart {
  Simulation<T> sim;
  ParticleBuffers<T> p;
  T dt;
  T weight;    ///< m: that gravity moves a particle by in a substep
  bool again;  ///< a repetition
  bool exact;  ///< as in CountTouching

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    if (c.row_width[block] == 0 || (again && c.busy[block] == 0)) return;
    const int i0 = block * block_size + lane0;
    const int32_t* touching = c.touching;
    if (!lanes.any([&](int l) WEFT_LANE { return touching[i0 + l] > 0; })) {
      const Vec3Array<T> push = c.push, brake = c.brake;
      lanes.each([=](int l) WEFT_LANE {
        store(push, i0 + l, Vec3<T>{T(0), T(0), T(0)});
        store(brake, i0 + l, Vec3<T>{T(0), T(0), T(0)});
      });
      return;
    }
    if (c.coincide[block] != 0) {
      const ForeignPairs<T> pairs{sim, p.x_out, sim.block.cloth[block]};
      return add_up<true>(pairs, block, i0, lane0, lanes);
    }
    with_pairs<N>(sim, p.x_out, block,
                  [&](auto pairs) { add_up<false>(pairs, block, i0, lane0, lanes); });
  }

 private:
  template <bool Coincide, class Pairs, int N>
  WEFT_HD void add_up(const Pairs& pairs, int block, int i0, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    const int of_cloth = sim.block.cloth[block];
    const bool asleep = sim.activity[of_cloth].asleep != 0;
    const T limit = T(c.cloth[of_cloth].wake_speed) * dt;
    LaneVec3<T, N> push, brake;
    int32_t wakes[N];
    lanes.each([&](int l) WEFT_LANE {
      push.set(l, {T(0), T(0), T(0)});
      brake.set(l, {T(0), T(0), T(0)});
      wakes[l] = 0;
    });
    if constexpr (N == block_size) {
      if (exact && is_sparse(c, block)) {
        add_alone(push_of<Coincide>(pairs, asleep, limit), block, push, brake, wakes);
        return give(block, i0, lanes, push, brake, wakes);
      }
    }
    add_rows(push_of<Coincide>(pairs, asleep, limit), block, lane0, lanes, push, brake, wakes);
    give(block, i0, lanes, push, brake, wakes);
  }

  template <class Of, int N>
  WEFT_HD void add_rows(Of of, int block, int lane0, Lanes<N> lanes, LaneVec3<T, N>& push,
                        LaneVec3<T, N>& brake, int32_t (&wakes)[N]) const {
    const Contacts<T>& c = sim.contacts;
    const int i0 = block * block_size + lane0, width = c.row_width[block];
    const int32_t* row = c.entry + c.row_start[block] + lane0;
    T* impulse = c.impulse + c.row_start[block] + lane0;
    for (int k = 0; k < width; ++k, row += block_size, impulse += block_size) {
      T given[N];  // of its own: others read what it may lie next to
      lanes.each([&](int l) WEFT_LANE { given[l] = impulse[l]; });
      lanes.each([&](int l) WEFT_LANE {
        const PairPush<T> by = of(i0 + l, row[l], given[l]);
        push.set(l, push.get(l) + by.push);
        brake.set(l, brake.get(l) + by.brake);
        given[l] = by.impulse;
        wakes[l] |= by.wakes;
      });
      lanes.each([&](int l) WEFT_LANE { impulse[l] = given[l]; });
    }
  }

  /// The same without filling (drop_filling).
  template <class Of, int N>
  WEFT_HD_COLD void add_alone(Of by, int block, LaneVec3<T, N>& push, LaneVec3<T, N>& brake,
                              int32_t (&wakes)[N]) const {
    const Of of = by;
    const int i0 = block * block_size;
    const Contacts<T>& c = sim.contacts;
    const int32_t* lane = c.entry + c.row_start[block];
    T* impulse = c.impulse + c.row_start[block];
    for (int left = c.busy[block]; left > 0; left -= block_size) {
      const int32_t* other = lane + block_size;
      LaneVec3<T, block_size> pushes, brakes;
      int32_t woken[block_size];
      T given[block_size];
      for (int e = 0; e < block_size; ++e) given[e] = impulse[e];
      Lanes<block_size>{}.each([&](int e) WEFT_LANE {
        const PairPush<T> one = of(i0 + lane[e], other[e], given[e]);
        pushes.set(e, one.push);
        brakes.set(e, one.brake);
        given[e] = one.impulse;
        woken[e] = one.wakes;
      });
      for (int e = 0; e < block_size; ++e) impulse[e] = given[e];
      for (int e = 0; e < smaller(left, block_size); ++e) {
        const int l = lane[e];
        push.set(l, push.get(l) + pushes.get(e));
        brake.set(l, brake.get(l) + brakes.get(e));
        wakes[l] |= woken[e];
      }
      lane += 2 * block_size;
      impulse += block_size;
    }
  }

  template <int N>
  WEFT_HD void give(int block, int i0, Lanes<N> lanes, const LaneVec3<T, N>& push,
                    const LaneVec3<T, N>& brake, const int32_t (&wakes)[N]) const {
    const Contacts<T>& c = sim.contacts;
    const int of_cloth = sim.block.cloth[block];
    const Vec3Array<T> push_out = c.push, brake_out = c.brake;
    lanes.each([&](int l) WEFT_LANE {
      store(push_out, i0 + l, push.get(l));
      store(brake_out, i0 + l, brake.get(l));
    });
    if (sim.activity[of_cloth].asleep &&
        lanes.any([&](int l) WEFT_LANE { return wakes[l] != 0; })) {
      atomic_most(c.woken + of_cloth, 1ull);
    }
  }

  template <bool Coincide, class Pairs>
  WEFT_HD auto push_of(const Pairs& pairs, bool asleep, T limit) const {
    const Contacts<T>& c = sim.contacts;
    return Push<Pairs, Coincide>{pairs,
                                 c.rank,
                                 sim.inverse_mass,
                                 c.touching,
                                 c.shift_of_form,
                                 p,
                                 c.friction,
                                 limit * limit,
                                 again ? T(0) : T(most_weights) * weight,
                                 asleep ? T(0) : T(1)};
  }

  /// What particle j does to particle i. `Coincide`: some may be at one place.
  template <class Pairs, bool Coincide>
  struct Push {
    Pairs pairs;
    const uint32_t* rank;
    const T* inverse_mass;
    const int32_t* touching;
    Vec3Array<T> shift;
    ParticleBuffers<T> buffers;
    T friction, limit2, most_carried, awake;

    WEFT_HD PairPush<T> operator()(int i, int j, T given) const {
      const Pair<T> pair = pairs(i, j);
      const T length2 = dot(pair.apart, pair.apart);
      const bool touches = (length2 < pair.distance * pair.distance) & (j != i);
      const bool met = given >= T(0);
      const T m_i = inverse_mass[i], m_j = inverse_mass[j];  // read in any case: no branch
      const T w_i = awake * m_i, w_j = pair.asleep ? T(0) : m_j;
      const T both = w_i + w_j;
      const int32_t count = touching[i] > touching[j] ? touching[i] : touching[j];
      const bool acts = met & (both > T(0));
      const T scale = both * T(count > 0 ? count : 1);
      const T part = acts ? T(1) / scale : T(0);
      const bool together = !(length2 > together_below<T>());
      const T length = together ? T(0) : square_root(length2);
      Vec3<T> n = (T(1) / (together ? T(1) : length)) * pair.apart;
      if constexpr (Coincide) n = select(together, direction_of_ranks<T>(rank[i], rank[j]), n);
      const Vec3<T> d_j = went(buffers, shift, j), slip = went(buffers, shift, i) - d_j;
      const T across = dot(slip, n), overlap = larger(T(0), pair.distance - length);
      const T carried = T(contact_passes) * smaller(overlap, most_carried);
      const T now = larger(T(0), given + part * (carried - across));
      const Vec3<T> sliding = slip - across * n;
      const T most = (friction / T(contact_passes)) * (scale * now);
      const T sliding2 = dot(sliding, sliding);
      const T held = sliding2 > most * most ? most / square_root(sliding2) : T(1);
      const T share = w_i * part;
      const Vec3<T> drag = (most > T(0) ? -held * share : T(0)) * sliding;
      const Vec3<T> none{T(0), T(0), T(0)};
      const bool fast = dot(d_j, d_j) > limit2;
      return {select(acts, (share * overlap) * n + drag, none),
              select(acts, (w_i * (now - given)) * n + drag, none), met ? now : T(-1),
              (touches & !pair.asleep & fast) ? 1 : 0};
    }
  };

  /// Displacement of this substep so far, without what overlaps have moved.
  WEFT_HD static Vec3<T> went(const ParticleBuffers<T>& p, const Vec3Array<T>& shift, int i) {
    if constexpr (Position) {
      return (load(p.x_out, i) - load(p.x_in, i)) - load(shift, i);
    } else {
      return load(p.d_out, i);
    }
  }
};

/// Moves the particles by it. In the position form the displacement follows from the positions:
/// what must not become speed is added up (Contacts::shift_of_form) and waits until the colliders
/// have spoken (KeepDisplacement), the position in the place of the push.
template <class T, bool Position>
struct ApplyPushes {
  Simulation<T> sim;
  ParticleBuffers<T> p;
  bool again;  ///< a repetition

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    if (c.row_width[block] == 0 || sim.activity[sim.block.cloth[block]].asleep) return;
    if (again && c.busy[block] == 0) return;
    const int i0 = block * block_size + lane0;
    const ParticleBuffers<T> buffers = p;
    const Vec3Array<T> pushes = c.push, brakes = c.brake, shift = c.shift_of_form;
    lanes.each([=](int l) WEFT_LANE {
      const Vec3<T> push = load(pushes, i0 + l), brake = load(brakes, i0 + l);
      const Vec3<T> to = load(buffers.x_out, i0 + l) + push;
      store(buffers.x_out, i0 + l, to);
      if constexpr (Position) {
        store(pushes, i0 + l, to);
        store(shift, i0 + l, load(shift, i0 + l) + (push - brake));
      } else {
        store(buffers.d_out, i0 + l, load(buffers.d_out, i0 + l) + brake);
      }
    });
  }
};

/// The position form's previous position, where no collider has moved the particle since.
template <class T>
struct KeepDisplacement {
  Simulation<T> sim;
  ParticleBuffers<T> p;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    if (c.row_width[block] == 0 || sim.activity[sim.block.cloth[block]].asleep) return;
    const int i0 = block * block_size + lane0;
    const ParticleBuffers<T> buffers = p;
    const Vec3Array<T> pushed = c.push, overlap = c.shift_of_form;
    lanes.each([=](int l) WEFT_LANE {
      const Vec3<T> x = load(buffers.x_out, i0 + l), to = load(pushed, i0 + l);
      const bool same = (x.x == to.x) & (x.y == to.y) & (x.z == to.z);
      const Vec3<T> before = load(buffers.x_in, i0 + l);
      store(buffers.x_in, i0 + l, select(same, before + load(overlap, i0 + l), before));
    });
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
