// Who touches whom, found anew in every substep, with little to do where nobody can.
//
// Particles that follow each other in memory go much the same way. So they are watched in groups of
// eight: a pair of groups that are d apart at some time has d left, of which each substep takes
// what the two may have come nearer, and is looked into when nothing is left. That never misses: a
// particle of one and one of the other come nearer by no more than their motions differ.
//
// Pairs that do not come near each other while both go on as they do, give or take a margin, are
// not kept. They are made anew, from boxes around groups, blocks and 32 blocks, when a group has
// left its margin, and keep what they had left. While all go nearly the same way, nobody even asks
// for pairs.
#pragma once

#include "kernels/may_meet.h"
#include "kernels/moving_groups.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// ContactGroups::apart of a pair that was not looked into before: a value that hardly any has, and
/// that does no harm to one that has it. And of what fills up a row: where particles go further
/// than any distance, it is looked into too, and must find nobody a second time.
constexpr uint64_t nobody_asked = 0x5555aaaa5555aaaaull, all_apart = ~uint64_t(0);

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
        if (room2[h] >= nowhere) continue;
        const double room = square_root(room2[h]) - still;
        others[found] = first + h;
        left[found++] = room > 0.0 ? T(room * (1.0 - 1e-5)) : T(-endless);
      }
      if (found > most_others) return false;
    }
    const int padded = (found + 7) / 8 * 8;
    const int64_t half = groups.capacity / 2;
    const auto taken =
        static_cast<int64_t>(atomic_take(&c.state->pairs, static_cast<unsigned long long>(padded)));
    if (taken + padded > half) return false;
    const int64_t start = taken + (c.state->lists % 2 != 0 ? half : 0);
    int64_t old = knows ? groups.pair_start[group] : 0;
    const int64_t end = knows ? old + groups.pair_count[group] : 0;
    for (int k = 0; k < padded; ++k) {
      const int other = k < found ? others[k] : group;
      T room = k < found ? left[k] : T(endless);
      uint64_t apart = k < found ? nobody_asked : all_apart;
      while (old < end && groups.other[old] < other) ++old;  // both go up, but for filling
      const bool filling = old < end && groups.left[old] > T(0.5 * endless);
      if (old < end && k < found && groups.other[old] == other && !filling) {
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

  static constexpr double nowhere = 1e300;

  /// Of the groups of a block: the square of how far their boxes are apart now; `nowhere` where
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
      room2[h] = larger(larger(x, y), z) > reach ? nowhere : gap;
    });
  }
};

/// The pairs that touch now, of the pairs of groups that have nothing left.
template <class T>
struct GroupFinder {
  Vec3Array<T> x;

  static constexpr int group = contact_group;
  static constexpr int few_looks = 8;  ///< of a group: not counted

  /// As CompleteFinder::search.
  template <int G, class Emit>
  WEFT_HD void search(const Simulation<T>& sim, int i, int, int, Emit emit) const {
    const ContactGroups<T>& groups = sim.contacts.groups;
    const int own = i / contact_group;
    const int64_t start = groups.pair_start[own], end = start + groups.pair_count[own];
    if constexpr (G == 1) {  // again, for one of them
      for (int64_t p = start; p < end; ++p) {
        if (!(groups.left[p] >= T(0))) look_from(sim, i, p, emit);
      }
    } else {
      T least = T(endless);
      int looks = 0;
      for (int64_t p = start; p < end; p += 8) {
        T left[8], onward[8];
        if (come_nearer(sim.contacts, own, p, left, onward)) {
          const T early = sim.contacts.early;
          for (int k = 0; k < 8; ++k) {
            if (left[k] - (early > T(0) ? onward[k] + early : T(0)) >= T(0)) continue;
            left[k] = groups.left[p + k] = look_into(sim, own, p + k, emit);
            ++looks;
          }
        }
        for (int k = 0; k < 8; ++k) least = smaller(left[k] - onward[k], least);
      }
      if (looks > few_looks)
        atomic_sum(&sim.contacts.state->looks, static_cast<unsigned long long>(looks));
      atomic_least(&sim.contacts.state->least_left, ordered(static_cast<double>(least)));
    }
  }

 private:
  /// Takes from eight pairs what their groups may have come nearer; whether any has nothing left,
  /// or would have where a look is worth it early. `onward`: what they would lose without a look.
  WEFT_HD static bool come_nearer(const Contacts<T>& c, int own, int64_t p, T (&left)[8],
                                  T (&onward)[8]) {
    const ContactGroups<T>& groups = c.groups;
    const T *mx = groups.motion[0], *my = groups.motion[1], *mz = groups.motion[2];
    const T* radius = groups.motion[3];
    const Vec3<T> way{mx[own], my[own], mz[own]};
    const T own_radius = radius[own], ahead = c.onward, early = c.early;
    const T counts = early > T(0) ? T(1) : T(0);
    const int32_t* others = groups.other + p;
    T* lefts = groups.left + p;
    Lanes<8>{}.each([&](int k) WEFT_LANE {
      const int o = others[k];
      const Vec3<T> off = Vec3<T>{mx[o], my[o], mz[o]} - way;
      const T apart = square_root(dot(off, off));
      const T nearer = apart + (own_radius + radius[o]);
      onward[k] = ahead * apart;
      left[k] = lefts[k] - T(1.00001) * nearer;
      lefts[k] = left[k];
    });
    return Lanes<8>{}.any(
        [&](int k) WEFT_LANE { return !(left[k] - (counts * onward[k] + early) >= T(0)); });
  }

  /// All particles of one with all of the other. Returns what is left.
  template <class Emit>
  WEFT_HD_COLD T look_into(const Simulation<T>& sim, int own, int64_t pair,
                           const Emit& emit) const {
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

  /// The same for one particle, where its group was looked into before.
  template <class Emit>
  WEFT_HD_COLD void look_from(const Simulation<T>& sim, int i, int64_t pair,
                              const Emit& emit) const {
    constexpr int G = contact_group;
    const Contacts<T>& c = sim.contacts;
    const int j0 = c.groups.other[pair] * G;
    const int a = sim.block.cloth[i / block_size], b = sim.block.cloth[j0 / block_size];
    const uint64_t apart = c.groups.apart[pair] >> (i % G);
    const ContactCloth &one = c.cloth[a], &two = c.cloth[b];
    const Vec3<T> between{T(one.origin[0] - two.origin[0]), T(one.origin[1] - two.origin[1]),
                          T(one.origin[2] - two.origin[2])};
    const T distance = T(0.5 * (one.distance + two.distance)), touching = distance * distance;
    const Vec3Array<T> at = x;
    const Vec3<T> here = load(at, i);
    T length2[G];
    Lanes<G>{}.each([&](int m) WEFT_LANE {
      const Vec3<T> d = (here - load(at, j0 + m)) + between;
      length2[m] = dot(d, d);
    });
    for (int m = 0; m < G; ++m) {
      if (length2[m] < touching && (apart >> (8 * m) & 1u) == 0) emit(0, j0 + m, b, true);
    }
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
