// What near particles do to each other: contact.md's response in two gathers over the rows of the
// list, all from the same positions (Jacobi). First each counts who touches it, then each adds up
// its share of every pair, divided by the larger count of the two. So what one gets the other
// gives, to the last bit but its own share's rounding, and a dense heap does not overshoot.
//
// Along the line of the two, n = (x_i - x_j)/|x_i - x_j|, the pair moves apart to its distance. Its
// displacements get an impulse that ends their approach, no more than it takes and never one that
// pulls (projected Jacobi: each pair keeps what it has given, and takes back what was too much).
// Friction holds what it can of the rest.
//
// One such pass hands a weight on by one layer of a heap, so they are repeated, in the pairs that
// touched before the first and by the counts of then: no list's age shows. What lies on a heap's
// lower layers has pressed them into each other by then. So an overlap is where an impulse begins,
// as far as it can be the weight of others (most_weights); of a deeper one nothing becomes speed.
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

/// Whether any particle of the block has gone further than its budget from where it would be if its
/// group went on as before it was looked at.
template <class T, int N>
WEFT_HD_COLD bool has_strayed(const Contacts<T>& c, Vec3Array<T> x, int end, int i0,
                              Lanes<N> lanes) {
  const Vec3Array<T> first = c.first;
  const T still = c.still, most = c.budget * c.budget;
  const T *mx = c.groups.motion[0], *my = c.groups.motion[1], *mz = c.groups.motion[2];
  constexpr int together = N < contact_group ? N : contact_group;
  LaneVec3<T, N> usual;
  for (int l = 0; l < N; l += together) {
    const int g = (i0 + l) / contact_group;
    const Vec3<T> of_group = still * Vec3<T>{mx[g], my[g], mz[g]};
    for (int k = 0; k < together; ++k) usual.set(l + k, of_group);
  }
  return lanes.any([&](int l) WEFT_LANE {
    const Vec3<T> off = (load(x, i0 + l) - load(first, i0 + l)) - usual.get(l);
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

/// Squared, m^2: nearer than this a pair has no direction of its own.
template <class T>
WEFT_HD constexpr T together_below() {
  return sizeof(T) == 4 ? T(1e-34) : T(1e-290);
}

template <class T>
WEFT_HD bool touch(const Pair<T>& pair) {
  return dot(pair.apart, pair.apart) < pair.distance * pair.distance;
}

/// Pairs within one cloth: nothing is to be looked up.
template <class T>
struct OwnPairs {
  Vec3Array<T> x;
  T distance;

  WEFT_HD Pair<T> operator()(int i, int j) const {
    return {load(x, i) - load(x, j), distance, false};
  }
};
/// And where another cloth is near, whose positions are relative to another origin.
template <class T>
struct ForeignPairs {
  Simulation<T> sim;
  Vec3Array<T> x;
  int of_cloth;

  WEFT_HD Pair<T> operator()(int i, int j) const {
    const int other = sim.block.cloth[j / block_size];
    const ContactCloth &a = sim.contacts.cloth[of_cloth], &b = sim.contacts.cloth[other];
    const Vec3<T> between{T(a.origin[0] - b.origin[0]), T(a.origin[1] - b.origin[1]),
                          T(a.origin[2] - b.origin[2])};
    return {(load(x, i) - load(x, j)) + between, T(0.5 * (a.distance + b.distance)),
            sim.activity[other].asleep != 0};
  }
};
/// The same of a world of few cloths, looked up once for a block.
constexpr int few_cloths = 128;
template <class T>
struct CloseCloths {
  T between[3][few_cloths], distance[few_cloths];
  int32_t asleep[few_cloths];

  WEFT_HD CloseCloths(const Simulation<T>& sim, int of_cloth) {
    const ContactCloth* cloths = sim.contacts.cloth;
    const ContactCloth& own = cloths[of_cloth];
    for (int k = 0; k < sim.contacts.cloths; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        between[axis][k] = T(own.origin[axis] - cloths[k].origin[axis]);
      }
      distance[k] = T(0.5 * (own.distance + cloths[k].distance));
      asleep[k] = sim.activity[k].asleep;
    }
  }
};
template <class T>
struct CloseForeignPairs {
  Vec3Array<T> x;
  const int32_t* cloth_of_block;
  const T *between_x, *between_y, *between_z, *distance;
  const int32_t* asleep;

  WEFT_HD CloseForeignPairs(const Simulation<T>& sim, Vec3Array<T> at, const CloseCloths<T>& all)
      : x(at),
        cloth_of_block(sim.block.cloth),
        between_x(all.between[0]),
        between_y(all.between[1]),
        between_z(all.between[2]),
        distance(all.distance),
        asleep(all.asleep) {}

  WEFT_HD Pair<T> operator()(int i, int j) const {
    const int other = cloth_of_block[j / block_size];
    const Vec3<T> between{between_x[other], between_y[other], between_z[other]};
    return {(load(x, i) - load(x, j)) + between, distance[other], asleep[other] != 0};
  }
};

/// Calls work(pairs) with what is known of the pairs of a block, to be used by N lanes at a time.
template <int N, class T, class Work>
WEFT_HD void with_pairs(const Simulation<T>& sim, Vec3Array<T> x, int block, Work work) {
  const int of_cloth = sim.block.cloth[block];
  if (sim.contacts.row_foreign[block] != 0) {
    if constexpr (N == block_size) {
      if (sim.contacts.cloths <= few_cloths) {
        const CloseCloths<T> cloths(sim, of_cloth);
        return work(CloseForeignPairs<T>(sim, x, cloths));
      }
    }
    work(ForeignPairs<T>{sim, x, of_cloth});
  } else {
    work(OwnPairs<T>{x, T(sim.contacts.cloth[of_cloth].distance)});
  }
}

/// Whether a host keeps of a block's rows, of which all or some touch, what is no filling alone: in
/// chunks of block_size entries, first their lanes and then the other particles, in the order of
/// the rows and in their place.
constexpr int most_alone = 8 * block_size;
template <class T>
WEFT_HD bool is_sparse(const Contacts<T>& c, int block) {
  const int chunks = (c.busy[block] + block_size - 1) / block_size;
  return 2 * chunks <= c.row_width[block] && chunks * block_size <= most_alone;
}
template <class T>
WEFT_HD void drop_filling(const Contacts<T>& c, int block) {
  const int width = c.row_width[block], i0 = block * block_size;
  int32_t* row = c.entry + c.row_start[block];
  int32_t lane[most_alone + 1], other[most_alone + 1];  // with room for what is not kept
  int n = 0;
  for (int k = 0; k < width * block_size; ++k) {
    lane[n] = k % block_size;
    other[n] = row[k];
    n += ((row[k] != i0 + k % block_size) & (n < most_alone)) ? 1 : 0;
  }
  T* impulse = c.impulse + c.row_start[block];
  for (int first = 0; first < n; first += block_size, row += 2 * block_size) {
    for (int l = 0; l < block_size; ++l) {
      const bool is = first + l < n;
      impulse[first + l] = is ? T(0) : T(-1);
      row[l] = is ? lane[first + l] : 0;
      row[block_size + l] = is ? other[first + l] : i0;
    }
  }
}
/// Counts the partners that touch before anything is put apart.
/// `exact`: rows hold nothing but such pairs.
template <class T>
struct CountTouching {
  Simulation<T> sim;
  Vec3Array<T> x;
  bool exact;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    const int width = c.row_width[block];
    if (width == 0) return;
    const int i0 = block * block_size + lane0;
    int32_t count[N], most[N], coincide[N];
    lanes.each([&](int l) WEFT_LANE { count[l] = coincide[l] = 0; });
    with_pairs<N>(sim, x, block, [&](auto pairs) {
      const int32_t* row = c.entry + c.row_start[block] + lane0;
      T* impulse = c.impulse + c.row_start[block] + lane0;
      for (int k = 0; k < width; ++k, row += block_size, impulse += block_size) {
        T given[N];
        lanes.each([&](int l) WEFT_LANE {
          const Pair<T> pair = pairs(i0 + l, row[l]);
          const bool touches = touch(pair) & (row[l] != i0 + l);
          const bool together = !(dot(pair.apart, pair.apart) > together_below<T>());
          count[l] += touches ? 1 : 0;
          coincide[l] |= (touches & together) ? 1 : 0;
          given[l] = touches ? T(0) : T(-1);
        });
        lanes.each([&](int l) WEFT_LANE { impulse[l] = given[l]; });
      }
    });
    int32_t* touching = c.touching;
    lanes.each([&](int l) WEFT_LANE {
      touching[i0 + l] = count[l];
      most[l] = count[l];
    });
    const int32_t all = sum_of_lanes(most, lanes);
    const int32_t any = sum_of_lanes(coincide, lanes);
    if (lane0 == 0) c.busy[block] = all;
    if (lane0 == 0) c.coincide[block] = any;
    if constexpr (N == block_size) {
      if (exact && is_sparse(c, block)) drop_filling(c, block);
    }
    const Vec3Array<T> now = x, first = c.first;
    lanes.each([=](int l) WEFT_LANE { store(first, i0 + l, load(now, i0 + l)); });
    if (c.shift_of_form.data == nullptr) return;
    const Vec3Array<T> shift = c.shift_of_form;
    lanes.each([=](int l) WEFT_LANE { store(shift, i0 + l, Vec3<T>{T(0), T(0), T(0)}); });
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
