// What near particles do to each other: contact.md's response in two gathers over the rows of the
// list, all from the same positions (Jacobi). First each counts who touches it, then each adds up
// its share of every pair, divided by the larger count of the two. So what one gets the other
// gives, to the last bit but its own share's rounding, and a dense heap does not overshoot.
//
// Along the line of the two, n = (x_i - x_j)/|x_i - x_j|, the pair moves apart to its distance. Of
// the displacements only the approach goes, so that an overlap gives no speed, and friction holds
// what it can of the rest.
//
// One such pass hands a weight on by one layer of a heap. So they are repeated, where there is
// anything to repeat: in the pairs that touched before the first, so that no list's age shows.
#pragma once

#include "base/atomic_words.h"
#include "base/lanes.h"
#include "kernels/particle_stages.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Whether colliders wait in this block for what other particles do to it.
template <class T>
WEFT_HD bool waits_for_contact(const Contacts<T>& c, int block) {
  if (c.waits != Waits::listed) return c.waits == Waits::every;
  return c.row_width[block] > 0;
}

/// Whether any particle of the block is further than a skin from where the list expects it.
template <class T, int N>
WEFT_HD_COLD bool has_outrun(const Contacts<T>& c, Vec3Array<T> x, int end, int i0,
                             Lanes<N> lanes) {
  const Vec3Array<T> from = c.from, drift = c.drift;
  const T age = c.age;
  const T* skin = c.skin_of;
  return lanes.any([=](int l) WEFT_LANE {
    const Vec3<T> off = (load(x, i0 + l) - load(from, i0 + l)) - age * load(drift, i0 + l);
    return (i0 + l < end) & (dot(off, off) > skin[i0 + l] * skin[i0 + l]);
  });
}

/// Whether any particle of the block has gone further than its budget from the average of all since
/// the groups were looked at.
template <class T, int N>
WEFT_HD_COLD bool has_strayed(const Contacts<T>& c, Vec3Array<T> x, int end, int i0,
                              Lanes<N> lanes) {
  const Vec3Array<T> first = c.first;
  const double* pace = c.state->pace;
  const Vec3<T> usual = c.still * Vec3<T>{T(pace[0]), T(pace[1]), T(pace[2])};
  const T most = c.budget * c.budget;
  return lanes.any([=](int l) WEFT_LANE {
    const Vec3<T> off = (load(x, i0 + l) - load(first, i0 + l)) - usual;
    return (i0 + l < end) & !(dot(off, off) <= most);
  });
}

/// A pair as particle i sees it.
template <class T>
struct Pair {
  Vec3<T> apart;  ///< x_i - x_j
  T distance;     ///< that they keep
  bool asleep;    ///< the other's cloth
};

/// Pairs within one cloth: nothing is to be looked up.
template <class T>
struct OwnPairs {
  Vec3Array<T> x;
  T distance;

  WEFT_HD Pair<T> operator()(int i, int j) const {
    return {load(x, i) - load(x, j), distance, false};
  }
  WEFT_HD Vec3<T> between(int) const { return {T(0), T(0), T(0)}; }
  WEFT_HD T distance_to(int) const { return distance; }
};
/// And where another cloth is near, whose positions are relative to another origin.
template <class T>
struct ForeignPairs {
  Simulation<T> sim;
  Vec3Array<T> x;
  int of_cloth;

  WEFT_HD Pair<T> operator()(int i, int j) const {
    const int other = sim.block.cloth[j / block_size];
    return {(load(x, i) - load(x, j)) + between(j), distance_to(j),
            sim.activity[other].asleep != 0};
  }
  /// From the other's origin to this one's.
  WEFT_HD Vec3<T> between(int j) const {
    const ContactCloth& a = sim.contacts.cloth[of_cloth];
    const ContactCloth& b = sim.contacts.cloth[sim.block.cloth[j / block_size]];
    return {T(a.origin[0] - b.origin[0]), T(a.origin[1] - b.origin[1]),
            T(a.origin[2] - b.origin[2])};
  }
  WEFT_HD T distance_to(int j) const {
    const ContactCloth& a = sim.contacts.cloth[of_cloth];
    return T(0.5 * (a.distance + sim.contacts.cloth[sim.block.cloth[j / block_size]].distance));
  }
};

/// Calls work(pairs) with what is known of the pairs of a block.
template <class T, class Work>
WEFT_HD void with_pairs(const Simulation<T>& sim, Vec3Array<T> x, int block, Work work) {
  const int of_cloth = sim.block.cloth[block];
  if (sim.contacts.row_foreign[block] != 0) {
    work(ForeignPairs<T>{sim, x, of_cloth});
  } else {
    work(OwnPairs<T>{x, T(sim.contacts.cloth[of_cloth].distance)});
  }
}

/// Whether a pair touched before anything was put apart in this substep.
template <class T, class Pairs>
WEFT_HD bool touched(const Pairs& pairs, const Vec3Array<T>& first, int i, int j) {
  const Vec3<T> apart = pairs.between(j) + (load(first, i) - load(first, j));
  const T distance = pairs.distance_to(j);
  return dot(apart, apart) < distance * distance;
}

/// Entries of a block's rows that are no filling, in the order of the rows, with a few behind them
/// that are.
constexpr int entries_at_once = 8, most_entries = 2 * block_size;
struct Entries {
  int32_t lane[most_entries + entries_at_once], other[most_entries + entries_at_once];
  int count;
};

/// Whether few of the entries of a block's rows touch.
template <class T>
WEFT_HD bool is_sparse(const Contacts<T>& c, int block) {
  return 4 * c.busy[block] < block_size * c.row_width[block];
}

/// Calls work(entries) until all of a block's rows are through. A host's.
template <class T, class Work>
WEFT_HD void each_entry(const Contacts<T>& c, int block, const Work& work) {
  const int width = c.row_width[block], i0 = block * block_size;
  const int32_t* row = c.entry + c.row_start[block];
  Entries of;
  int n = 0;
  for (int k = 0; k < width; ++k, row += block_size) {
    for (int l = 0; l < block_size; ++l) {
      of.lane[n] = l;
      of.other[n] = row[l];
      n += row[l] != i0 + l ? 1 : 0;
    }
    if (n <= most_entries - block_size && k + 1 < width) continue;
    for (int e = n; e < n + entries_at_once; ++e) {
      of.lane[e] = 0;
      of.other[e] = i0;
    }
    of.count = n;
    work(of);
    n = 0;
  }
}

/// Counts the partners that touch. `Again`: in a repetition.
template <class T, bool Again>
struct CountTouching {
  Simulation<T> sim;
  Vec3Array<T> x;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    const int width = c.row_width[block];
    if (width == 0 || (Again && c.busy[block] == 0)) return;
    const int i0 = block * block_size + lane0;
    const Vec3Array<T> first = c.first;
    int32_t count[N], most[N];
    lanes.each([&](int l) WEFT_LANE { count[l] = 0; });
    with_pairs(sim, x, block, [&](auto pairs) {
      const int32_t* row = c.entry + c.row_start[block] + lane0;
      if constexpr (Again && N == block_size) {
        if (is_sparse(c, block)) {
          each_entry(c, block, [&](const Entries& of) {
            int32_t touches[most_entries];
            for (int from = 0; from < of.count; from += entries_at_once) {
              Lanes<entries_at_once>{}.each([&](int e) WEFT_LANE {
                const int i = i0 + of.lane[from + e], j = of.other[from + e];
                const Pair<T> pair = pairs(i, j);
                const bool touch = dot(pair.apart, pair.apart) < pair.distance * pair.distance;
                touches[from + e] = (touch & touched(pairs, first, i, j) & (j != i)) ? 1 : 0;
              });
            }
            for (int e = 0; e < of.count; ++e) count[of.lane[e]] += touches[e];
          });
          return;
        }
      }
      for (int k = 0; k < width; ++k, row += block_size) {
        lanes.each([&](int l) WEFT_LANE {
          const int j = row[l];
          const Pair<T> pair = pairs(i0 + l, j);
          const bool touches = dot(pair.apart, pair.apart) < pair.distance * pair.distance;
          const bool met = !Again || touched(pairs, first, i0 + l, j);
          count[l] += (touches & met & (j != i0 + l)) ? 1 : 0;
        });
      }
    });
    int32_t* touching = c.touching;
    lanes.each([&](int l) WEFT_LANE {
      touching[i0 + l] = count[l];
      most[l] = count[l];
    });
    if constexpr (!Again) {
      const int32_t all = sum_of_lanes(most, lanes);
      if (lane0 == 0) c.busy[block] = all;
      const Vec3Array<T> now = x;
      lanes.each([=](int l) WEFT_LANE { store(first, i0 + l, load(now, i0 + l)); });
      if (c.shift_of_form.data == nullptr) return;
      const Vec3Array<T> shift = c.shift_of_form;
      lanes.each([=](int l) WEFT_LANE { store(shift, i0 + l, Vec3<T>{T(0), T(0), T(0)}); });
    }
  }
};

/// Unit vector of two particles at one place, away from the one of higher rank.
template <class T>
WEFT_HD Vec3<T> direction_of_ranks(uint32_t a, uint32_t b) {
  const uint32_t low = a < b ? a : b, high = a < b ? b : a;
  const uint32_t mixed = (low * 0x9e3779b1u ^ high) * 0x85ebca6bu;
  const uint32_t axis = (mixed >> 16) % 3u;
  const T sign = ((mixed >> 9 & 1u) != 0) != (a < b) ? T(1) : T(-1);
  return {axis == 0 ? sign : T(0), axis == 1 ? sign : T(0), axis == 2 ? sign : T(0)};
}

/// What one particle does to another.
template <class T>
struct PairPush {
  Vec3<T> push, brake;
  int32_t wakes;  ///< 1: it would wake the other
};

/// What the partners of each particle do to it, into memory of its own: the others still read its
/// position.
template <class T, bool Position>
struct PushApart {
  Simulation<T> sim;
  ParticleBuffers<T> p;
  T dt;
  int again;  ///< 1: a repetition

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    if (c.row_width[block] == 0 || (again != 0 && c.busy[block] == 0)) return;
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
    with_pairs(sim, p.x_out, block, [&](auto pairs) { add_up(pairs, block, i0, lane0, lanes); });
  }

 private:
  template <class Pairs, int N>
  WEFT_HD void add_up(const Pairs& pairs, int block, int i0, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    const int of_cloth = sim.block.cloth[block], width = c.row_width[block];
    const bool asleep = sim.activity[of_cloth].asleep != 0;
    const T limit = T(c.cloth[of_cloth].wake_speed) * dt;
    LaneVec3<T, N> push, brake;
    int32_t wakes[N];
    lanes.each([&](int l) WEFT_LANE {
      push.set(l, {T(0), T(0), T(0)});
      brake.set(l, {T(0), T(0), T(0)});
      wakes[l] = 0;
    });
    const Push<Pairs> of{pairs,         c.rank,         sim.inverse_mass, c.touching,
                         c.first,       c.shift_of_form, p,                c.friction,
                         limit * limit, again == 0,      asleep};
    if constexpr (N == block_size) {
      if (is_sparse(c, block)) {
        each_entry(c, block, [&](const Entries& entries) {
          add_entries(of, entries, i0, push, brake, wakes);
        });
        return give(block, i0, lanes, push, brake, wakes);
      }
    }
    const int32_t* row = c.entry + c.row_start[block] + lane0;
    for (int k = 0; k < width; ++k, row += block_size) {
      lanes.each([&](int l) WEFT_LANE {
        const PairPush<T> by = of(i0 + l, row[l]);
        push.set(l, push.get(l) + by.push);
        brake.set(l, brake.get(l) + by.brake);
        wakes[l] |= by.wakes;
      });
    }
    give(block, i0, lanes, push, brake, wakes);
  }

  /// The same for some entries of a block's rows.
  template <class Of, int N>
  WEFT_HD_COLD static void add_entries(const Of& by, const Entries& entries, int i0,
                                       LaneVec3<T, N>& push, LaneVec3<T, N>& brake,
                                       int32_t (&wakes)[N]) {
    const Of of = by;  // loops read locals only
    for (int from = 0; from < entries.count; from += entries_at_once) {
      LaneVec3<T, entries_at_once> more, less;
      int32_t wake[entries_at_once];
      const int32_t *lane = entries.lane + from, *other = entries.other + from;
      Lanes<entries_at_once>{}.each([&](int e) WEFT_LANE {
        const PairPush<T> one = of(i0 + lane[e], other[e]);
        more.set(e, one.push);
        less.set(e, one.brake);
        wake[e] = one.wakes;
      });
      for (int e = 0; e < entries_at_once && from + e < entries.count; ++e) {
        const int l = lane[e];
        push.set(l, push.get(l) + more.get(e));
        brake.set(l, brake.get(l) + less.get(e));
        wakes[l] |= wake[e];
      }
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
    if (sim.activity[of_cloth].asleep && lanes.any([&](int l) WEFT_LANE { return wakes[l] != 0; })) {
      atomic_most(c.woken + of_cloth, 1ull);
    }
  }

  /// What particle j does to particle i.
  template <class Pairs>
  struct Push {
    Pairs pairs;
    const uint32_t* rank;
    const T* inverse_mass;
    const int32_t* touching;
    Vec3Array<T> first_x, shift;
    ParticleBuffers<T> buffers;
    T friction, limit2;
    bool first, asleep;

    WEFT_HD PairPush<T> operator()(int i, int j) const {
      const T tiny = sizeof(T) == 4 ? T(1e-34) : T(1e-290);
      const Pair<T> pair = pairs(i, j);
      const T length2 = dot(pair.apart, pair.apart);
      const bool acting = first | touched(pairs, first_x, i, j);
      const bool touches = (length2 < pair.distance * pair.distance) & (j != i) & acting;
      const T m_i = inverse_mass[i], m_j = inverse_mass[j];  // read in any case: no branch
      const T w_i = asleep ? T(0) : m_i, w_j = pair.asleep ? T(0) : m_j;
      const T both = w_i + w_j;
      const int32_t count = touching[i] > touching[j] ? touching[i] : touching[j];
      const bool acts = touches & (both > T(0));
      const T share = acts ? w_i / (both * T(count > 0 ? count : 1)) : T(0);
      const bool together = !(length2 > tiny);
      const T length = together ? T(0) : square_root(length2);
      const Vec3<T> n = select(together, direction_of_ranks<T>(rank[i], rank[j]),
                               (T(1) / (together ? T(1) : length)) * pair.apart);
      const Vec3<T> d_j = went(buffers, shift, j), slip = went(buffers, shift, i) - d_j;
      const T across = dot(slip, n), against = larger(T(0), -across);
      const Vec3<T> sliding = slip - across * n;
      const T most = friction * against, sliding2 = dot(sliding, sliding);
      const T held = sliding2 > most * most ? most / square_root(sliding2) : T(1);
      const Vec3<T> drag = (most > T(0) ? -held : T(0)) * sliding;
      const Vec3<T> none{T(0), T(0), T(0)};
      const bool fast = dot(d_j, d_j) > limit2;
      return {select(acts, share * ((pair.distance - length) * n + drag), none),
              select(acts, share * (against * n + drag), none),
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
  int again;  ///< 1: a repetition

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    if (c.row_width[block] == 0 || sim.activity[sim.block.cloth[block]].asleep) return;
    if (again != 0 && c.busy[block] == 0) return;
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
