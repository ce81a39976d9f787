// How groups of eight particles move: what they have gone since they were looked at, and where they
// are expected to come by (near_groups.h).
#pragma once

#include "kernels/cells.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Larger than any distance between particles, of which the square is finite too.
constexpr double endless = 1e15;

/// Bounds of three components, by group.
template <class T>
struct BoundsOfGroups {
  T low[3][groups_a_block], high[3][groups_a_block];
};
template <class T>
WEFT_HD void bound_groups(const T (&value)[block_size], T (&low)[groups_a_block],
                          T (&high)[groups_a_block]) {
  for (int g = 0; g < groups_a_block; ++g) {
    const T* of = value + g * contact_group;
    T least = of[0], most = of[0];
    for (int k = 1; k < contact_group; ++k) {
      least = smaller(least, of[k]);
      most = larger(most, of[k]);
    }
    low[g] = least;
    high[g] = most;
  }
}

/// How far each group has gone since it was looked at. From now on it counts anew.
template <class T>
struct MoveGroups {
  Simulation<T> sim;
  Vec3Array<T> x;
  int since;  ///< substeps

  template <int N>
  WEFT_HD void operator()(int block, int, Lanes<N> lanes) const {
    static_assert(N == block_size, "a host's kernel");
    const Contacts<T>& c = sim.contacts;
    const int i0 = block * block_size, end = sim.cloths[sim.block.cloth[block]].end;
    const Vec3Array<T> now = x, first = c.first;
    LaneVec3<T, N> way;
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> at = load(now, i0 + l), none{T(0), T(0), T(0)};
      const Vec3<T> gone = select(i0 + l < end, at - load(first, i0 + l), none);
      store(first, i0 + l, at);
      way.set(l, gone);
    });
    BoundsOfGroups<T> of;
    bound_groups(way.x, of.low[0], of.high[0]);
    bound_groups(way.y, of.low[1], of.high[1]);
    bound_groups(way.z, of.low[2], of.high[2]);
    T middle[3][groups_a_block], around[N], nearest[groups_a_block], radius[groups_a_block];
    for (int g = 0; g < groups_a_block; ++g) {
      for (int axis = 0; axis < 3; ++axis) {
        middle[axis][g] = T(0.5) * (of.low[axis][g] + of.high[axis][g]);
      }
      const Vec3<T> center{middle[0][g], middle[1][g], middle[2][g]};
      Lanes<contact_group>{}.each([&](int k) WEFT_LANE {
        const Vec3<T> off = way.get(g * contact_group + k) - center;
        around[g * contact_group + k] = dot(off, off);
      });
    }
    bound_groups(around, nearest, radius);
    double beyond = endless, ahead = endless, pace = 0.0;
    for (int g = 0; g < groups_a_block; ++g) {
      const int at = block * groups_a_block + g;
      const double spread = static_cast<double>(square_root(radius[g]));
      double off[3], from_all[3];
      for (int axis = 0; axis < 3; ++axis) {
        const T gone = middle[axis][g];
        c.groups.motion[axis][at] = gone;
        off[axis] = static_cast<double>(gone) - since * c.groups.speed[axis][at];
        from_all[axis] = static_cast<double>(gone) - since * c.state->pace[axis];
      }
      c.groups.motion[3][at] = square_root(radius[g]);
      const double unexpected = length(off), odd = length(from_all);
      const double went = (unexpected + spread) * (1.0 + 1e-5);
      c.groups.path[at] += went;
      c.groups.usual[at] = went / since;
      beyond = smaller(c.groups.margin[at] - c.groups.path[at], beyond);
      pace = larger(odd + spread, pace);
      const double onward = static_cast<double>(c.onward) * unexpected;
      ahead = smaller(c.groups.margin[at] - c.groups.path[at] - onward, ahead);
      if (!(c.groups.path[at] >= 0.0)) beyond = -endless;  // not a number
    }
    atomic_least(&c.state->least_beyond, ordered(beyond));
    atomic_most(&c.state->most_pace, ordered(pace / since));
    atomic_least(&c.state->least_ahead, ordered(ahead));
  }

 private:
  WEFT_HD static double length(const double* v) {
    return square_root((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]);
  }
};

/// Boxes around groups where they are now, and around where blocks come by while pairs last.
template <class T>
struct BoxGroups {
  Simulation<T> sim;
  ParticleBuffers<T> p;
  int since;    ///< substeps of what is known of motions; 0: nothing is
  int horizon;  ///< substeps
  double part;  ///< of the usual margins

  template <int N>
  WEFT_HD void operator()(int block, int, Lanes<N> lanes) const {
    static_assert(N == block_size, "a host's kernel");
    const Contacts<T>& c = sim.contacts;
    const ContactGroups<T>& groups = c.groups;
    const int i0 = block * block_size, of_cloth = sim.block.cloth[block];
    const int end = sim.cloths[of_cloth].end;
    const Vec3Array<T> now = p.x_out, first = c.first;
    LaneVec3<T, N> least, most;
    const T far = T(3e38);
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> at = load(now, i0 + l);
      store(first, i0 + l, at);
      const T zero = (at.x - at.x) + (at.y - at.y) + (at.z - at.z);
      const bool counts = (i0 + l < end) & (zero == T(0));
      least.set(l, select(counts, at, Vec3<T>{far, far, far}));
      most.set(l, select(counts, at, Vec3<T>{-far, -far, -far}));
    });
    BoundsOfGroups<T> of, other;
    bound_groups(least.x, of.low[0], other.high[0]);
    bound_groups(least.y, of.low[1], other.high[1]);
    bound_groups(least.z, of.low[2], other.high[2]);
    bound_groups(most.x, other.low[0], of.high[0]);
    bound_groups(most.y, other.low[1], of.high[1]);
    bound_groups(most.z, other.low[2], of.high[2]);
    double all[6], beyond = endless;
    for (int g = 0; g < groups_a_block; ++g) {
      const int at = block * groups_a_block + g;
      const double margin = margin_of(at);
      double speed[3];
      expect(at, i0 + g * contact_group, speed);
      for (int axis = 0; axis < 3; ++axis) {
        const double origin = c.cloth[of_cloth].origin[axis];
        const double at_low = in_world(of.low[axis][g], origin);
        const double at_high = in_world(of.high[axis][g], origin);
        groups.low[axis][at] = at_low;
        groups.high[axis][at] = at_high;
        groups.speed[axis][at] = speed[axis];
        const double off = speed[axis] - c.state->pace[axis];
        const double low = at_low - margin + smaller(horizon * off, 0.0);
        const double high = at_high + margin + larger(horizon * off, 0.0);
        all[axis] = g == 0 ? low : smaller(all[axis], low);
        all[3 + axis] = g == 0 ? high : larger(all[3 + axis], high);
      }
      if (since == 0) {
        for (int k = 0; k < 4; ++k) groups.motion[k][at] = T(0);
      }
      groups.path[at] = 0.0;
      groups.margin[at] = margin;
      beyond = smaller(beyond, margin);
    }
    for (int k = 0; k < 6; ++k) groups.block_box[6 * block + k] = all[k];
    atomic_least(&c.state->least_beyond, ordered(beyond));
    atomic_least(&c.state->least_ahead, ordered(beyond));
  }

 private:
  /// In distances; and the substeps that it is meant for.
  static constexpr double least_margin = 0.5, most_margin = 6, margin_paces = 24;

  /// Who does not go as expected needs more of a margin.
  WEFT_HD double margin_of(int group) const {
    const Contacts<T>& c = sim.contacts;
    const double wanted = since > 0 ? margin_paces * c.groups.usual[group] : 0.0;
    return part *
           larger(least_margin * c.most_distance, smaller(wanted, most_margin * c.most_distance));
  }
  WEFT_HD void expect(int group, int i, double (&speed)[3]) const {
    const T* const* motion = sim.contacts.groups.motion;
    const Vec3<T> d = load(p.x_out, i) - load(p.x_in, i);
    const double now[3] = {static_cast<double>(d.x), static_cast<double>(d.y),
                           static_cast<double>(d.z)};
    for (int axis = 0; axis < 3; ++axis) {
      const double one = since > 0 ? static_cast<double>(motion[axis][group]) / since : now[axis];
      speed[axis] = one - one == 0.0 ? one : 0.0;
    }
  }
};

/// Boxes around 32 blocks; the first one also clears what pairs of groups are counted with.
template <class T>
struct BoxBlocks {
  Contacts<T> contacts;
  int blocks;
  int horizon;

  template <int N>
  WEFT_HD void operator()(int of, int, Lanes<N>) const {
    const double* box = contacts.groups.block_box;
    const int begin = 32 * of, end = begin + 32 < blocks ? begin + 32 : blocks;
    double all[6];
    for (int k = 0; k < 6; ++k) all[k] = box[6 * begin + k];
    for (int b = begin + 1; b < end; ++b) {
      for (int k = 0; k < 3; ++k) all[k] = smaller(all[k], box[6 * b + k]);
      for (int k = 3; k < 6; ++k) all[k] = larger(all[k], box[6 * b + k]);
    }
    for (int k = 0; k < 6; ++k) contacts.groups.super_box[6 * of + k] = all[k];
    if (of != 0) return;
    ContactState& state = *contacts.state;
    state.pair_horizon = horizon;
    state.paired = contacts.substep;
    state.pairs = 0;
    state.crowded = 0;
    state.lists += 1;
  }
};

/// What all particles went in a substep, on average of some of them: whoever goes so, goes along.
template <class T>
struct AverageMotion {
  Simulation<T> sim;
  int since;  ///< substeps

  template <int N>
  WEFT_HD void operator()(int, int, Lanes<N>) const {
    ContactState& state = *sim.contacts.state;
    const int groups = sim.blocks * groups_a_block;
    for (int axis = 0; axis < 3; ++axis) {
      const T* motion = sim.contacts.groups.motion[axis];
      double sum = 0.0;
      int count = 0;
      for (int g = 0; g < groups; g += 5, ++count) sum += static_cast<double>(motion[g]);
      const double mean = sum / (double(count) * since);
      const double now = mean - mean == 0.0 ? mean : 0.0;
      state.pace[axis] = now;
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
