// Who touches whom, found anew in every substep, with little to do where nobody can.
//
// Particles that follow each other in memory go much the same way. So they are watched in groups of
// eight: a pair of groups that are d apart at some time has d left, of which each substep takes
// what the two may have come nearer, and is looked into when nothing is left. That never misses: a
// particle of one and one of the other come nearer by no more than their motions differ.
//
// Pairs that are further apart than a margin are not kept. They are made anew, from boxes around
// groups, around blocks and around 32 blocks, when a particle may have left its
// margin. And while all have gone nearly the same way, nobody even asks for pairs.
#pragma once

#include "kernels/cells.h"
#include "kernels/may_meet.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Larger than any distance between particles, of which the square is finite too.
constexpr double endless = 1e15;
/// ContactGroups::apart of a pair that was not looked into before.
constexpr uint64_t nobody_asked = ~uint64_t(0);

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
    double beyond = endless, pace = 0.0, drift = 0.0;
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
      drift = larger(unexpected + odd, drift);
      if (!(c.groups.path[at] >= 0.0)) beyond = -endless;  // not a number
    }
    atomic_least(&c.state->least_beyond, ordered(beyond));
    atomic_most(&c.state->most_pace, ordered(pace / since));
    atomic_most(&c.state->most_drift, ordered(drift / since));
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
    double all[6], beyond = endless, drift2 = 0.0;
    for (int g = 0; g < groups_a_block; ++g) {
      const int at = block * groups_a_block + g;
      const double margin = margin_of(at);
      double speed[3];
      expect(at, i0 + g * contact_group, speed);
      double from_pace2 = 0.0;
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
        from_pace2 += off * off;
      }
      drift2 = larger(drift2, from_pace2);
      if (since == 0) {
        for (int k = 0; k < 4; ++k) groups.motion[k][at] = T(0);
      }
      groups.path[at] = 0.0;
      groups.margin[at] = margin;
      beyond = smaller(beyond, margin);
    }
    for (int k = 0; k < 6; ++k) groups.block_box[6 * block + k] = all[k];
    atomic_least(&c.state->least_beyond, ordered(beyond));
    atomic_most(&c.state->most_drift, ordered(square_root(drift2)));
  }

 private:
  /// In distances; and the substeps that it is meant for.
  static constexpr double least_margin = 0.5, most_margin = 6, margin_paces = 24;

  /// Who does not go as expected needs more of a margin.
  WEFT_HD double margin_of(int group) const {
    const Contacts<T>& c = sim.contacts;
    const double wanted = since > 0 ? margin_paces * c.groups.usual[group] : 0.0;
    return part * larger(least_margin * c.most_distance,
                         smaller(wanted, most_margin * c.most_distance));
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

/// Whether any particle of cloth `a` may meet one of `b`.
WEFT_HD bool cloths_meet(const ContactCloth* cloth, int a, int b) {
  const ContactCloth &one = cloth[a], &other = cloth[b];
  if (a == b) return one.itself != 0;
  return ((one.others & other.others) != 0) & ((one.layers & other.layers) != 0);
}

/// The pairs of groups that come near each other, or leave what is expected of them.
template <class T>
struct PairGroups {
  Simulation<T> sim;
  int horizon;
  bool knows;  ///< what is left of the pairs that there were

  template <int N>
  WEFT_HD void operator()(int block, int, Lanes<N>) const {
    static_assert(N == block_size, "a host's kernel");
    const Contacts<T>& c = sim.contacts;
    ContactState& state = *c.state;
    if (atomic_take(&state.crowded, 0) != 0) return;
    NearBlock near[most_blocks];
    const int found = near_blocks(block, near);
    bool fits = found <= most_blocks;
    for (int g = 0; g < groups_a_block && fits; ++g) {
      fits = pair(block * groups_a_block + g, near, found);
    }
    if (!fits) atomic_most(&state.crowded, 1ull);
  }

 private:
  static constexpr int most_blocks = 320, most_others = 192;
  static constexpr double unit = sizeof(T) == 4 ? 1e-6 : 1e-15;  ///< of rounding

  WEFT_HD static bool far(const double* a, const double* b, double reach) {
    return (b[0] - a[3] > reach) | (a[0] - b[3] > reach) | (b[1] - a[4] > reach) |
           (a[1] - b[4] > reach) | (b[2] - a[5] > reach) | (a[2] - b[5] > reach);
  }

  /// And how near is touching, with what rounding may make of it.
  struct NearBlock {
    int32_t block;
    double distance;  ///< m
  };

  WEFT_HD int near_blocks(int block, NearBlock* near) const {
    const Contacts<T>& c = sim.contacts;
    const ContactGroups<T>& groups = c.groups;
    const int of_cloth = sim.block.cloth[block];
    const double* own = groups.block_box + 6 * block;
    const double reach = 0.5 * (c.cloth[of_cloth].distance + c.most_distance);
    int found = 0;
    const int supers = (sim.blocks + 31) / 32;
    for (int s = 0; s < supers; ++s) {
      if (far(own, groups.super_box + 6 * s, reach)) continue;
      const int end = 32 * s + 32 < sim.blocks ? 32 * s + 32 : sim.blocks;
      for (int b = 32 * s; b < end; ++b) {
        if (far(own, groups.block_box + 6 * b, reach)) continue;
        if (!cloths_meet(c.cloth, of_cloth, sim.block.cloth[b])) continue;
        if (found == most_blocks) return found + 1;
        near[found++] = {b, distance_to(of_cloth, sim.block.cloth[b], own)};
      }
    }
    return found;
  }

  WEFT_HD double distance_to(int a, int b, const double* box) const {
    const ContactCloth &one = sim.contacts.cloth[a], &other = sim.contacts.cloth[b];
    double distance = 0.5 * (one.distance + other.distance) * (1.0 + 1e-5);
    for (int axis = 0; axis < 3; ++axis) {
      const double between = one.origin[axis] - other.origin[axis];
      const double size = larger(box[3 + axis], -box[axis]);
      distance += unit * larger(between, -between) + 1e-15 * larger(size, 0.0);
    }
    return distance;
  }

  /// False: there is no room.
  WEFT_HD bool pair(int group, const NearBlock* near, int blocks) const {
    const Contacts<T>& c = sim.contacts;
    const ContactGroups<T>& groups = c.groups;
    const double margin = groups.margin[group];
    Moving own;
    double swept[6];
    for (int axis = 0; axis < 3; ++axis) {
      own.low[axis] = groups.low[axis][group];
      own.high[axis] = groups.high[axis][group];
      own.speed[axis] = groups.speed[axis][group];
      const double way = horizon * (own.speed[axis] - c.state->pace[axis]);
      swept[axis] = own.low[axis] - margin + smaller(way, 0.0);
      swept[3 + axis] = own.high[axis] + margin + larger(way, 0.0);
    }
    int32_t others[most_others + groups_a_block];
    T left[most_others + groups_a_block];
    int found = 0;
    for (int k = 0; k < blocks; ++k) {
      const double still = near[k].distance;
      if (far(swept, groups.block_box + 6 * near[k].block, still)) continue;
      const int first = near[k].block * groups_a_block;
      double room2[groups_a_block];
      meet(own, groups, first, margin, still, room2);
      for (int h = 0; h < groups_a_block; ++h) {
        if (room2[h] >= endless) continue;
        const double room = square_root(room2[h]) - still;
        others[found] = first + h;
        left[found++] = room > 0.0 ? T(room * (1.0 - 1e-5)) : T(-endless);
      }
      if (found > most_others) return false;
    }
    const int padded = (found + 7) / 8 * 8;
    const int64_t half = groups.capacity / 2;
    const auto taken = static_cast<int64_t>(
        atomic_take(&c.state->pairs, static_cast<unsigned long long>(padded)));
    if (taken + padded > half) return false;
    const auto start = static_cast<int32_t>(taken + (c.state->lists % 2 != 0 ? half : 0));
    int old = knows ? groups.pair_start[group] : 0;
    const int end = knows ? old + groups.pair_count[group] : 0;
    for (int k = 0; k < padded; ++k) {
      const int other = k < found ? others[k] : group;
      T room = k < found ? left[k] : T(endless);
      uint64_t apart = nobody_asked;
      while (old < end && groups.other[old] < other) ++old;  // both go up, but for filling
      if (old < end && k < found && groups.other[old] == other) {
        room = groups.left[old];
        apart = groups.apart[old];
      }
      groups.other[start + k] = other;
      groups.left[start + k] = room;
      groups.apart[start + k] = apart;
    }
    groups.pair_start[group] = start;
    groups.pair_count[group] = padded;
    return true;
  }

  /// A group's box, and how it goes on.
  struct Moving {
    double low[3], high[3], speed[3];
  };

  /// Of the groups of a block: the square of how far their boxes are apart now; `endless` where
  /// they do not come near while all go on as expected.
  WEFT_HD void meet(const Moving& own, const ContactGroups<T>& groups, int first, double margin,
                    double distance, double (&room2)[groups_a_block]) const {
    const Moving a = own;
    const double *low0 = groups.low[0] + first, *high0 = groups.high[0] + first;
    const double *low1 = groups.low[1] + first, *high1 = groups.high[1] + first;
    const double *low2 = groups.low[2] + first, *high2 = groups.high[2] + first;
    const double *speed0 = groups.speed[0] + first, *speed1 = groups.speed[1] + first;
    const double *speed2 = groups.speed[2] + first, *margins = groups.margin + first;
    const double span = horizon;
    Lanes<groups_a_block>{}.each([&](int h) WEFT_LANE {
      const double reach = distance + (margin + margins[h]);
      const double above0 = low0[h] - a.high[0], below0 = a.low[0] - high0[h];
      const double above1 = low1[h] - a.high[1], below1 = a.low[1] - high1[h];
      const double above2 = low2[h] - a.high[2], below2 = a.low[2] - high2[h];
      const double way0 = span * (speed0[h] - a.speed[0]);
      const double way1 = span * (speed1[h] - a.speed[1]);
      const double way2 = span * (speed2[h] - a.speed[2]);
      // The largest of these is how far apart they stay.
      const double x = larger(above0 + smaller(way0, 0.0), below0 - larger(way0, 0.0));
      const double y = larger(above1 + smaller(way1, 0.0), below1 - larger(way1, 0.0));
      const double z = larger(above2 + smaller(way2, 0.0), below2 - larger(way2, 0.0));
      const double gap0 = larger(larger(above0, below0), 0.0);
      const double gap1 = larger(larger(above1, below1), 0.0);
      const double gap2 = larger(larger(above2, below2), 0.0);
      const double gap = (gap0 * gap0 + gap1 * gap1) + gap2 * gap2;
      room2[h] = larger(larger(x, y), z) > reach ? endless : gap;
    });
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
    double change = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const T* motion = sim.contacts.groups.motion[axis];
      double sum = 0.0;
      int count = 0;
      for (int g = 0; g < groups; g += 5, ++count) sum += static_cast<double>(motion[g]);
      const double mean = sum / (double(count) * since);
      const double now = mean - mean == 0.0 ? mean : 0.0;
      change += larger(now - state.pace[axis], state.pace[axis] - now);
      state.pace[axis] = now;
    }
    state.pace_change = change;
  }
};

/// The pairs that touch now, of the pairs of groups that have nothing left.
template <class T>
struct GroupFinder {
  Vec3Array<T> x;

  static constexpr int group = contact_group;

  /// As CompleteFinder::search.
  template <int G, class Emit>
  WEFT_HD void search(const Simulation<T>& sim, int i, int, int, Emit emit) const {
    const ContactGroups<T>& groups = sim.contacts.groups;
    const int own = i / contact_group, start = groups.pair_start[own];
    const int end = start + groups.pair_count[own];
    if constexpr (G == 1) {  // again, for one of them
      for (int p = start; p < end; ++p) {
        if (groups.left[p] >= T(0)) continue;
        look_into(sim, own, p, [&](int l, int32_t j, int of_j, bool meets) {
          if (l == i % contact_group) emit(0, j, of_j, meets);
        });
      }
    } else {
      T least = T(endless);
      for (int p = start; p < end; p += 8) {
        T left[8];
        if (come_nearer(groups, own, p, left)) {
          for (int k = 0; k < 8; ++k) {
            if (left[k] >= T(0)) continue;
            left[k] = groups.left[p + k] = look_into(sim, own, p + k, emit);
          }
        }
        for (int k = 0; k < 8; ++k) least = smaller(least, left[k]);
      }
      atomic_least(&sim.contacts.state->least_left, ordered(static_cast<double>(least)));
    }
  }

 private:
  /// Takes from eight pairs what their groups may have come nearer; whether any has nothing left.
  WEFT_HD static bool come_nearer(const ContactGroups<T>& groups, int own, int p, T (&left)[8]) {
    const T *mx = groups.motion[0], *my = groups.motion[1], *mz = groups.motion[2];
    const T* radius = groups.motion[3];
    const Vec3<T> way{mx[own], my[own], mz[own]};
    const T own_radius = radius[own];
    const int32_t* others = groups.other + p;
    T* lefts = groups.left + p;
    Lanes<8>{}.each([&](int k) WEFT_LANE {
      const int o = others[k];
      const Vec3<T> off = Vec3<T>{mx[o], my[o], mz[o]} - way;
      const T nearer = square_root(dot(off, off)) + (own_radius + radius[o]);
      left[k] = lefts[k] - T(1.00001) * nearer;
      lefts[k] = left[k];
    });
    return Lanes<8>{}.any([&](int k) WEFT_LANE { return !(left[k] >= T(0)); });
  }

  /// All particles of one with all of the other. Returns what is left.
  template <class Emit>
  WEFT_HD_COLD T look_into(const Simulation<T>& sim, int own, int pair, const Emit& emit) const {
    constexpr int G = contact_group;
    const Contacts<T>& c = sim.contacts;
    const int other = c.groups.other[pair];
    const int a = sim.block.cloth[own / groups_a_block];
    const int b = sim.block.cloth[other / groups_a_block];
    uint64_t apart = c.groups.apart[pair];
    if (apart == nobody_asked) {
      apart = who_never_meets(sim, own, other, a, b);
      c.groups.apart[pair] = apart;
    }
    const ContactCloth &one = c.cloth[a], &two = c.cloth[b];
    const Vec3<T> between{T(one.origin[0] - two.origin[0]), T(one.origin[1] - two.origin[1]),
                          T(one.origin[2] - two.origin[2])};
    const T distance = T(0.5 * (one.distance + two.distance)), touching = distance * distance;
    const Vec3Array<T> at = x;
    const int i0 = own * G, j0 = other * G;
    LaneVec3<T, G> here;
    T least[G], apart2[G][G];
    Lanes<G>{}.each([&](int l) WEFT_LANE {
      here.set(l, load(at, i0 + l));
      least[l] = T(endless) * T(endless);
    });
    for (int m = 0; m < G; ++m) {
      const Vec3<T> there = load(at, j0 + m);
      const int never = static_cast<int>(apart >> (8 * m) & 255u);
      Lanes<G>{}.each([&](int l) WEFT_LANE {
        const Vec3<T> d = (here.get(l) - there) + between;
        const T length2 = (never >> l & 1) != 0 ? T(endless) * T(endless) : dot(d, d);
        apart2[m][l] = length2;
        least[l] = smaller(length2, least[l]);
      });
    }
    T nearest = least[0];
    for (int l = 1; l < G; ++l) nearest = smaller(nearest, least[l]);
    if (nearest < touching) {
      for (int m = 0; m < G; ++m) {
        for (int l = 0; l < G; ++l) {
          if (apart2[m][l] < touching) emit(l, j0 + m, b, true);
        }
      }
    }
    constexpr T unit = sizeof(T) == 4 ? T(1e-6) : T(1e-15);
    const T size = larger(between.x, -between.x) + larger(between.y, -between.y) +
                   larger(between.z, -between.z);
    return T(0.99999) * square_root(nearest) - (T(1.00001) * distance + unit * size);
  }

  WEFT_HD static uint64_t who_never_meets(const Simulation<T>& sim, int own, int other, int a,
                                          int b) {
    constexpr int G = contact_group;
    const Contacts<T>& c = sim.contacts;
    const int i0 = own * G, j0 = other * G;
    const int end_a = sim.cloths[a].end, end_b = sim.cloths[b].end;
    const double excluded = c.cloth[a].distance * c.cloth[a].distance;
    const double* rest = c.rest;
    double x[G], y[G], z[G];
    for (int l = 0; l < G; ++l) {
      x[l] = rest[3 * (int64_t(i0) + l)];
      y[l] = rest[3 * (int64_t(i0) + l) + 1];
      z[l] = rest[3 * (int64_t(i0) + l) + 2];
    }
    uint64_t apart = 0;
    for (int m = 0; m < G; ++m) {
      const double* q = rest + 3 * (int64_t(j0) + m);
      const double qx = q[0], qy = q[1], qz = q[2];
      int never[G];
      const bool absent = j0 + m >= end_b, itself = a == b;
      Lanes<G>{}.each([&](int l) WEFT_LANE {
        const double dx = x[l] - qx, dy = y[l] - qy, dz = z[l] - qz;
        const bool at_rest = (dx * dx + dy * dy) + dz * dz < excluded;
        const bool same = i0 + l == j0 + m;
        never[l] = ((i0 + l >= end_a) | absent | same | (itself & at_rest)) ? 1 : 0;
      });
      for (int l = 0; l < G; ++l) apart |= uint64_t(never[l]) << (8 * m + l);
    }
    return apart;
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
