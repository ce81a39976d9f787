// Who touches whom, found anew in every substep, with little to do where nobody can.
//
// Particles that follow each other in memory go much the same way. So they are watched in groups of
// eight: a pair of groups that are d apart at some time has d left, of which each substep takes
// what the two may have come nearer, and is looked into when nothing is left. That never misses: a
// particle of one and one of the other come nearer by no more than their motions differ.
//
// Pairs that are further apart than a margin are not kept. They are made anew, from boxes around
// groups, around blocks and around 32 blocks, when a particle may have used up its half of the
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

/// The smallest, or largest, of each group's values in the place of its first.
template <class T>
WEFT_HD void smallest_of_groups(T (&value)[block_size + contact_group]) {
  for (int half = contact_group / 2; half > 0; half /= 2) {
    WEFT_SIMD
    for (int l = 0; l < block_size; ++l) value[l] = smaller(value[l], value[l + half]);
  }
}
template <class T>
WEFT_HD void largest_of_groups(T (&value)[block_size + contact_group]) {
  for (int half = contact_group / 2; half > 0; half /= 2) {
    WEFT_SIMD
    for (int l = 0; l < block_size; ++l) value[l] = larger(value[l], value[l + half]);
  }
}

/// Bounds of three components, by group.
template <class T>
struct BoundsOfGroups {
  T low[3][block_size + contact_group], high[3][block_size + contact_group];

  WEFT_HD void reduce() {
    for (int axis = 0; axis < 3; ++axis) {
      smallest_of_groups(low[axis]);
      largest_of_groups(high[axis]);
    }
  }
};

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
    const Vec3<T> usual = T(since) * Vec3<T>{T(c.state->pace[0]), T(c.state->pace[1]),
                                             T(c.state->pace[2])};
    const Vec3Array<T> now = x, first = c.first;
    LaneVec3<T, N> way;
    BoundsOfGroups<T> of{};
    T further[N];
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> at = load(now, i0 + l), none{T(0), T(0), T(0)};
      const Vec3<T> gone = select(i0 + l < end, at - load(first, i0 + l), none);
      store(first, i0 + l, at);
      way.set(l, gone);
      of.low[0][l] = of.high[0][l] = gone.x;
      of.low[1][l] = of.high[1][l] = gone.y;
      of.low[2][l] = of.high[2][l] = gone.z;
      const Vec3<T> off = gone - usual;
      further[l] = i0 + l < end ? dot(off, off) : T(0);
    });
    of.reduce();
    T middle[3][N], radius[block_size + contact_group] = {};
    for (int l = 0; l < N; ++l) {
      const int of_group = l / contact_group * contact_group;
      for (int axis = 0; axis < 3; ++axis) {
        middle[axis][l] = T(0.5) * (of.low[axis][of_group] + of.high[axis][of_group]);
      }
    }
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> off = way.get(l) - Vec3<T>{middle[0][l], middle[1][l], middle[2][l]};
      radius[l] = dot(off, off);
    });
    largest_of_groups(radius);
    for (int g = 0; g < groups_a_block; ++g) {
      const int at = block * groups_a_block + g, l = g * contact_group;
      for (int axis = 0; axis < 3; ++axis) c.groups.motion[axis][at] = middle[axis][l];
      c.groups.motion[3][at] = square_root(radius[l]);
    }
    const double most = static_cast<double>(square_root(largest_of_lanes(further, lanes)));
    const double path = c.groups.path[block] + most * (1.0 + 1e-5);
    c.groups.path[block] = path;
    atomic_most(&c.state->most_path, ordered(path));
    atomic_most(&c.state->most_pace, ordered(most / since));
  }
};

/// Boxes around groups and blocks, where they are now.
template <class T>
struct BoxGroups {
  Simulation<T> sim;
  Vec3Array<T> x;

  template <int N>
  WEFT_HD void operator()(int block, int, Lanes<N> lanes) const {
    static_assert(N == block_size, "a host's kernel");
    const Contacts<T>& c = sim.contacts;
    const ContactGroups<T>& groups = c.groups;
    const int i0 = block * block_size, of_cloth = sim.block.cloth[block];
    const int end = sim.cloths[of_cloth].end;
    const Vec3Array<T> now = x, first = c.first;
    BoundsOfGroups<T> of{};
    const T far = T(3e38);
    lanes.each([&](int l) WEFT_LANE {
      const Vec3<T> at = load(now, i0 + l);
      store(first, i0 + l, at);
      const T zero = (at.x - at.x) + (at.y - at.y) + (at.z - at.z);
      const bool counts = (i0 + l < end) & (zero == T(0));
      const Vec3<T> low = select(counts, at, Vec3<T>{far, far, far});
      const Vec3<T> high = select(counts, at, Vec3<T>{-far, -far, -far});
      of.low[0][l] = low.x;
      of.low[1][l] = low.y;
      of.low[2][l] = low.z;
      of.high[0][l] = high.x;
      of.high[1][l] = high.y;
      of.high[2][l] = high.z;
    });
    of.reduce();
    double all[6];
    for (int g = 0; g < groups_a_block; ++g) {
      const int at = block * groups_a_block + g;
      for (int axis = 0; axis < 3; ++axis) {
        const double origin = c.cloth[of_cloth].origin[axis];
        const double low = in_world(of.low[axis][g * contact_group], origin);
        const double high = in_world(of.high[axis][g * contact_group], origin);
        groups.box[6 * at + axis] = low;
        groups.box[6 * at + 3 + axis] = high;
        all[axis] = g == 0 ? low : smaller(all[axis], low);
        all[3 + axis] = g == 0 ? high : larger(all[3 + axis], high);
      }
      for (int k = 0; k < 4; ++k) groups.motion[k][at] = T(0);
    }
    for (int k = 0; k < 6; ++k) groups.block_box[6 * block + k] = all[k];
    groups.path[block] = 0.0;
  }
};

/// Boxes around 32 blocks; the first one also clears what pairs of groups are counted with.
template <class T>
struct BoxBlocks {
  Contacts<T> contacts;
  int blocks;
  double margin;  ///< ContactState::margin

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
    state.margin = margin;
    state.pairs = 0;
    state.crowded = 0;
    state.most_path = ordered(0.0);
    state.lists += 1;
  }
};

/// Whether any particle of cloth `a` may meet one of `b`.
WEFT_HD bool cloths_meet(const ContactCloth* cloth, int a, int b) {
  const ContactCloth &one = cloth[a], &other = cloth[b];
  if (a == b) return one.itself != 0;
  return ((one.others & other.others) != 0) & ((one.layers & other.layers) != 0);
}

/// The pairs of groups that are not further apart than the margin.
template <class T>
struct PairGroups {
  Simulation<T> sim;

  template <int N>
  WEFT_HD void operator()(int block, int, Lanes<N>) const {
    static_assert(N == block_size, "a host's kernel");
    const Contacts<T>& c = sim.contacts;
    const ContactGroups<T>& groups = c.groups;
    ContactState& state = *c.state;
    for (int g = 0; g < groups_a_block; ++g) groups.pair_count[block * groups_a_block + g] = 0;
    if (atomic_take(&state.crowded, 0) != 0) return;
    int32_t near[most_blocks];
    const int found = near_blocks(block, near);
    if (found > most_blocks) {
      atomic_most(&state.crowded, 1ull);
      return;
    }
    for (int g = 0; g < groups_a_block; ++g) pair(block * groups_a_block + g, near, found);
  }

 private:
  static constexpr int most_blocks = 320, most_others = 160;
  static constexpr double unit = sizeof(T) == 4 ? 1e-6 : 1e-15;  ///< of rounding

  WEFT_HD static bool far(const double* a, const double* b, double reach) {
    return (b[0] - a[3] > reach) | (a[0] - b[3] > reach) | (b[1] - a[4] > reach) |
           (a[1] - b[4] > reach) | (b[2] - a[5] > reach) | (a[2] - b[5] > reach);
  }

  WEFT_HD int near_blocks(int block, int32_t* near) const {
    const Contacts<T>& c = sim.contacts;
    const ContactGroups<T>& groups = c.groups;
    const int of_cloth = sim.block.cloth[block];
    const double* own = groups.block_box + 6 * block;
    const double reach = 0.5 * (c.cloth[of_cloth].distance + c.most_distance) + c.state->margin;
    int found = 0;
    const int supers = (sim.blocks + 31) / 32;
    for (int s = 0; s < supers; ++s) {
      if (far(own, groups.super_box + 6 * s, reach)) continue;
      const int end = 32 * s + 32 < sim.blocks ? 32 * s + 32 : sim.blocks;
      for (int b = 32 * s; b < end; ++b) {
        if (far(own, groups.block_box + 6 * b, reach)) continue;
        if (!cloths_meet(c.cloth, of_cloth, sim.block.cloth[b])) continue;
        if (found == most_blocks) return found + 1;
        near[found++] = b;
      }
    }
    return found;
  }

  WEFT_HD void pair(int group, const int32_t* near, int blocks) const {
    const Contacts<T>& c = sim.contacts;
    const ContactGroups<T>& groups = c.groups;
    ContactState& state = *c.state;
    const ContactCloth& cloth = c.cloth[sim.block.cloth[group / groups_a_block]];
    const double* own = groups.box + 6 * group;
    int32_t others[most_others];
    T left[most_others];
    int found = 0;
    for (int k = 0; k < blocks; ++k) {
      const ContactCloth& theirs = c.cloth[sim.block.cloth[near[k]]];
      const double distance = 0.5 * (cloth.distance + theirs.distance);
      const double reach = distance + state.margin;
      double rounding = 1e-5 * distance;
      for (int axis = 0; axis < 3; ++axis) {
        const double between = cloth.origin[axis] - theirs.origin[axis];
        rounding += unit * larger(between, -between) + 1e-15 * larger(own[3 + axis], -own[axis]);
      }
      for (int h = 0; h < groups_a_block; ++h) {
        const int other = near[k] * groups_a_block + h;
        const double* box = groups.box + 6 * other;
        if (far(own, box, reach)) continue;
        if (found == most_others) {
          atomic_most(&state.crowded, 1ull);
          return;
        }
        others[found] = other;
        left[found++] = room_between(own, box, distance + rounding);
      }
    }
    const int padded = (found + 7) / 8 * 8;
    const auto start = static_cast<int64_t>(
        atomic_take(&state.pairs, static_cast<unsigned long long>(padded)));
    if (start + padded > groups.capacity) {
      atomic_most(&state.crowded, 1ull);
      return;
    }
    groups.pair_start[group] = static_cast<int32_t>(start);
    groups.pair_count[group] = padded;
    for (int k = 0; k < padded; ++k) {
      groups.other[start + k] = k < found ? others[k] : group;
      groups.left[start + k] = k < found ? left[k] : T(endless);
      groups.apart[start + k] = nobody_asked;
    }
  }

  /// What is left of a pair of groups by their boxes; below zero, where these are too near to say.
  WEFT_HD static T room_between(const double* a, const double* b, double distance) {
    double room2 = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double gap = larger(larger(b[axis] - a[3 + axis], a[axis] - b[3 + axis]), 0.0);
      room2 += gap * gap;
    }
    const double left = square_root(room2) - distance;
    return left > 0.0 ? T(left * (1.0 - 1e-5)) : T(-endless);
  }
};

/// What all particles went in a substep, on average of some of them: whoever goes so, goes along.
template <class T>
struct AverageMotion {
  Simulation<T> sim;
  int since;  ///< substeps

  template <int N>
  WEFT_HD void operator()(int, int, Lanes<N>) const {
    const int groups = sim.blocks * groups_a_block;
    for (int axis = 0; axis < 3; ++axis) {
      const T* motion = sim.contacts.groups.motion[axis];
      double sum = 0.0;
      int count = 0;
      for (int g = 0; g < groups; g += 5, ++count) sum += static_cast<double>(motion[g]);
      const double mean = sum / (double(count) * since);
      sim.contacts.state->pace[axis] = mean - mean == 0.0 ? mean : 0.0;
    }
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
