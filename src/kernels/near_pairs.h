// The list of pairs that are near, or may come near while it lasts.
//
// Complete: every pair that will be nearer than its distance lies in cells that are no further away
// than that distance and all that the two may drift apart meanwhile. Those around a particle are a
// few runs of the sorted order, since cells along x follow each other.
#pragma once

#include "kernels/cells.h"
#include "kernels/may_meet.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Before the first substep of a frame whose lists nobody looks at until its end.
template <class T>
struct ForgetLists {
  Contacts<T> contacts;

  template <int N>
  WEFT_HD void operator()(int, int lane0, Lanes<N>) const {
    if (lane0 != 0) return;
    contacts.state->outrun = 0;
    contacts.state->most = 0;
  }
};

/// Rows of the list are written by what all kinds of search have in common: a Finder names the
/// candidates of a few particles at a time, each once.
template <class T, class Finder>
struct WriteRows {
  Simulation<T> sim;
  Finder finder;

  /// Candidates that are remembered from the count; longer rows are searched for twice.
  static constexpr int most_kept = 48;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    const int i0 = block * block_size + lane0, of_cloth = sim.block.cloth[block];
    const int end = sim.cloths[of_cloth].end;
    int32_t kept[N][most_kept + 1];  // with room for what is not kept
    int32_t count[N], foreign[N], most[N];
    lanes.each_alone([&](int l) { count[l] = foreign[l] = 0; });
    constexpr int group = N < Finder::group ? N : Finder::group;
    for (int from = 0; from < N && i0 + from < end; from += group) {
      const int real = end - (i0 + from) < group ? end - (i0 + from) : group;
      finder.template search<group>(sim, i0 + from, real, of_cloth,
                                    [&](int l, int32_t j, int of_j, bool meets) {
                                      const int lane = from + l, n = count[lane];
                                      kept[lane][n < most_kept ? n : most_kept] = j;
                                      count[lane] = n + (meets ? 1 : 0);
                                      foreign[lane] |= (meets & (of_j != of_cloth)) ? 1 : 0;
                                    });
    }
    lanes.each_alone([&](int l) { most[l] = count[l]; });
    const int width = WEFT_OF_FIRST_LANE(largest_of_lanes(most, lanes));
    const int any_foreign = WEFT_OF_FIRST_LANE(largest_of_lanes(foreign, lanes));
    unsigned long long start = 0;
    const auto wanted = static_cast<unsigned long long>(width) * block_size;
    if (lane0 == 0 && width > 0) start = atomic_take(&c.state->used, wanted);
    if (lane0 == 0 && width > 0) atomic_most(&c.state->most, start + wanted);
    start = WEFT_OF_FIRST_LANE(start);
    const bool fits = start + wanted <= static_cast<unsigned long long>(c.capacity);
    if (lane0 == 0) {
      c.row_start[block] = static_cast<int64_t>(start);
      c.row_width[block] = fits ? width : 0;
      c.row_foreign[block] = any_foreign;
    }
    if (!fits || width == 0) return;
    lanes.each_alone([&](int l) {
      int32_t* row = c.entry + start + lane0 + l;
      int n = count[l];
      if (n <= most_kept) {
        write_sorted(c.rank, kept[l], n, row);
      } else {
        n = 0;
        finder.template search<1>(sim, i0 + l, 1, of_cloth, [&](int, int32_t j, int, bool meets) {
          if (meets && n < count[l]) row[int64_t(n++) * block_size] = j;
        });
        heap_sort(c.rank, row, n);
      }
      for (; n < width; ++n) row[int64_t(n) * block_size] = i0 + l;
    });
  }

 private:
  /// By ascending rank: each goes behind all that are below it.
  WEFT_HD static void write_sorted(const uint32_t* rank, const int32_t* kept, int n, int32_t* row) {
    uint32_t ranks[most_kept];
    for (int k = 0; k < n; ++k) ranks[k] = rank[kept[k]];
    for (int k = 0; k < n; ++k) {
      int below = 0;
      for (int m = 0; m < n; ++m) below += ranks[m] < ranks[k] ? 1 : 0;
      row[int64_t(below) * block_size] = kept[k];
    }
  }
  WEFT_HD static void heap_sort(const uint32_t* rank, int32_t* row, int n) {
    for (int k = n / 2 - 1; k >= 0; --k) sink(rank, row, k, n);
    for (int k = n - 1; k > 0; --k) {
      const int32_t last = row[int64_t(k) * block_size];
      row[int64_t(k) * block_size] = row[0];
      row[0] = last;
      sink(rank, row, 0, k);
    }
  }
  WEFT_HD static void sink(const uint32_t* rank, int32_t* row, int k, int n) {
    const int32_t entry = row[int64_t(k) * block_size];
    for (int child = 2 * k + 1; child < n; child = 2 * k + 1) {
      if (child + 1 < n &&
          rank[row[int64_t(child + 1) * block_size]] > rank[row[int64_t(child) * block_size]]) {
        ++child;
      }
      if (rank[row[int64_t(child) * block_size]] <= rank[entry]) break;
      row[int64_t(k) * block_size] = row[int64_t(child) * block_size];
      k = child;
    }
    row[int64_t(k) * block_size] = entry;
  }
};

/// Every pair that the list must hold. Particles that follow each other in memory are mostly near
/// each other: eight of them look through the cells around all eight together. What comes near
/// their common box is then compared with each, the eight at once.
template <class T>
struct CompleteFinder {
  Vec3Array<T> x;

  static constexpr int group = 8;

  /// emit(lane, j, cloth of j, whether they meet) for each candidate of the lanes below `count`
  /// from particle i on.
  template <int G, class Emit>
  WEFT_HD void search(const Simulation<T>& sim, int i, int count, int of_cloth, Emit emit) const {
    const Contacts<T>& c = sim.contacts;
    const ContactState& state = *c.state;
    Group<G> all;
    gather(c, i, count, of_cloth, all);
    if (!all.any) return;
    uint32_t first[3];
    int cells[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double inverse = state.inverse_cell[axis], reach = all.reach[axis];
      first[axis] = floor_bits((all.low[axis] - reach) * inverse);
      cells[axis] = count_of(all.low[axis] - reach, all.high[axis] + reach, inverse, most_cells);
    }
    if constexpr (G > 1) {
      // Who are far from each other look alone.
      if (cells[0] > 4 * G || cells[1] > 2 * G || cells[2] > 2 * G || cells[1] * cells[2] > 8 * G) {
        for (int l = 0; l < count; ++l) {
          search<1>(sim, i + l, 1, of_cloth,
                    [&](int, int32_t j, int of_j, bool meets) { emit(l, j, of_j, meets); });
        }
        return;
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto along = static_cast<int64_t>(state.mask[axis]) + 1;
      if (cells[axis] > along) cells[axis] = static_cast<int>(along);
    }
    const auto candidate = [&](int l, int at_sorted) {
      const auto j = static_cast<int32_t>(c.element[at_sorted]);
      const int of_j = c.cloth_of_spot[at_sorted];
      emit(l, j, of_j, may_meet(c, i + l, j, of_cloth, of_j));
    };
    const uint32_t left = first[0] & state.mask[0];
    const uint32_t right = (first[0] + static_cast<uint32_t>(cells[0]) - 1u) & state.mask[0];
    int32_t kept[most_kept];
    int n = 0;
    for (int dz = 0; dz < cells[2]; ++dz) {
      const uint32_t z = ((first[2] + static_cast<uint32_t>(dz)) & state.mask[2]) << state.shift[2];
      for (int dy = 0; dy < cells[1]; ++dy) {
        const uint32_t y = (first[1] + static_cast<uint32_t>(dy)) & state.mask[1];
        const uint32_t row = y << state.shift[1] | z;
        if (left <= right) {
          n = keep(c, all, c.cell_start[row | left], c.cell_start[(row | right) + 1u], kept, n,
                   candidate);
        } else {  // around the end
          n = keep(c, all, c.cell_start[row], c.cell_start[(row | right) + 1u], kept, n, candidate);
          n = keep(c, all, c.cell_start[row | left], c.cell_start[(row | state.mask[0]) + 1u], kept,
                   n, candidate);
        }
      }
    }
    compare(c, all, kept, n, candidate);
  }

 private:
  static constexpr int most_kept = 64, chunk = 4, run = 8;
  static constexpr int most_cells = 1 << 28;
  /// Cells from one place to another, at most `most`: numbers of cells wrap around.
  WEFT_HD static int count_of(double from, double to, double inverse, int most) {
    if (!((to - from) * inverse < double(most - 1))) return most;
    const auto count = static_cast<int>(floor_bits(to * inverse) - floor_bits(from * inverse)) + 1;
    return count < most ? count : most;
  }
  /// A radius that no other makes a reach of.
  WEFT_HD static constexpr T nobody() {
    if constexpr (sizeof(T) == 4) {
      return T(-3e38);
    } else {
      return T(-1e308);
    }
  }

  /// Particles that look for all that come nearer than the radii of both while both drift.
  template <int G>
  struct Group {
    LaneVec3<T, G> spot, drift;
    T radius[G];  ///< below zero where nothing is to be found
    T horizon, most_radius;
    double low[3], high[3];       ///< from state.low: of all
    Vec3<T> near_low, near_high;  ///< the same while they drift, relative to their mean drift
    Vec3<T> mean;
    double reach[3];  ///< m: how far away what they look for can be
    int first;        ///< particle
    bool any;
  };

  template <int G>
  WEFT_HD void gather(const Contacts<T>& c, int i, int count, int of_cloth, Group<G>& all) const {
    const ContactState& state = *c.state;
    const ContactCloth& cloth = c.cloth[of_cloth];
    const bool lasts = state.horizon > 0;
    all.horizon = T(state.horizon);
    all.any = false;
    all.first = i;
    all.most_radius = T(0);
    const T half = T(0.5 * (cloth.distance + state.slack));
    const T far = T(1e30);
    Vec3<T> slow{far, far, far}, fast{-far, -far, -far};
    for (int l = 0; l < G; ++l) {
      const int at = l < count ? i + l : i;
      const Vec3<T> now = load(x, at);
      const T zero = (now.x - now.x) + (now.y - now.y) + (now.z - now.z);
      const bool live = (l < count) & (zero == T(0));
      const double from_low[3] = {in_world(now.x, cloth.origin[0]) - state.low[0],
                                  in_world(now.y, cloth.origin[1]) - state.low[1],
                                  in_world(now.z, cloth.origin[2]) - state.low[2]};
      const Vec3<T> drift = lasts ? load(c.drift, at) : Vec3<T>{T(0), T(0), T(0)};
      all.spot.set(l, {T(from_low[0]), T(from_low[1]), T(from_low[2])});
      all.drift.set(l, drift);
      const T radius = half + (lasts ? c.skin_of[at] : T(0));
      all.radius[l] = live ? radius : nobody();
      if (!live) continue;
      all.most_radius = larger(all.most_radius, radius);
      slow = {smaller(slow.x, drift.x), smaller(slow.y, drift.y), smaller(slow.z, drift.z)};
      fast = {larger(fast.x, drift.x), larger(fast.y, drift.y), larger(fast.z, drift.z)};
      for (int axis = 0; axis < 3; ++axis) {
        all.low[axis] = all.any ? smaller(all.low[axis], from_low[axis]) : from_low[axis];
        all.high[axis] = all.any ? larger(all.high[axis], from_low[axis]) : from_low[axis];
      }
      all.any = true;
    }
    if (!all.any) return;
    look_around(c, slow, fast, all);
    all.mean = T(0.5) * (slow + fast);
    const Vec3<T> spread = (T(0.5) * all.horizon) * (fast - slow);
    all.near_low = Vec3<T>{T(all.low[0]), T(all.low[1]), T(all.low[2])} - spread;
    all.near_high = Vec3<T>{T(all.high[0]), T(all.high[1]), T(all.high[2])} + spread;
  }

  /// How far they have to look, by how those around them drift.
  template <int G>
  WEFT_HD static void look_around(const Contacts<T>& c, Vec3<T> slow, Vec3<T> fast, Group<G>& all) {
    const ContactState& state = *c.state;
    uint32_t first[3];
    int zones[3];
    for (int axis = 0; axis < 3; ++axis) {
      all.reach[axis] = state.reach[axis];
      if (state.horizon == 0) continue;
      first[axis] = zone_along(state, axis, all.low[axis] - state.reach[axis]);
      zones[axis] = count_of(all.low[axis] - state.reach[axis], all.high[axis] + state.reach[axis],
                             state.inverse_zone[axis], 1 << zone_bits);
    }
    if (state.horizon == 0) return;
    unsigned long long slowest[3], fastest[3], skin = 0;
    for (int axis = 0; axis < 3; ++axis) {
      slowest[axis] = ~0ull;
      fastest[axis] = 0;
    }
    for (int z = 0; z < zones[2]; ++z) {
      for (int y = 0; y < zones[1]; ++y) {
        for (int x_ = 0; x_ < zones[0]; ++x_) {
          const ContactZone& zone = c.zone[zone_of(first[0] + static_cast<uint32_t>(x_),
                                                   first[1] + static_cast<uint32_t>(y),
                                                   first[2] + static_cast<uint32_t>(z))];
          for (int axis = 0; axis < 3; ++axis) {
            slowest[axis] = smaller(slowest[axis], zone.slowest[axis]);
            fastest[axis] = larger(fastest[axis], zone.fastest[axis]);
          }
          skin = larger(skin, zone.most_skin);
        }
      }
    }
    const double own_slow[3] = {double(slow.x), double(slow.y), double(slow.z)};
    const double own_fast[3] = {double(fast.x), double(fast.y), double(fast.z)};
    const double still = double(all.most_radius) + 0.5 * (c.most_distance + state.slack);
    for (int axis = 0; axis < 3; ++axis) {
      const double apart = larger(unordered(fastest[axis]) - own_slow[axis],
                                  own_fast[axis] - unordered(slowest[axis]));
      const double reach = (still + unordered(skin) + double(state.horizon) * apart) * (1.0 + 1e-6);
      all.reach[axis] = smaller(reach, state.reach[axis]);
    }
  }

  /// Keeps, of a run of the sorted order, what comes near the box of all.
  template <int G, class Candidate>
  WEFT_HD static int keep(const Contacts<T>& c, const Group<G>& all, uint32_t begin, uint32_t end,
                          int32_t* kept, int n, const Candidate& candidate) {
    const Vec3Array<T> spots = c.spot, drifts = c.drift_of_spot;
    const T* radii = c.radius_of_spot;
    const Vec3<T> low = all.near_low, high = all.near_high, mean = all.mean;
    const T horizon = all.horizon, own = all.most_radius, zero = T(0);
    for (uint32_t from = begin; from < end; from += run) {
      const int q0 = static_cast<int>(from);
      const uint32_t rest = end - from;
      const int real = rest < uint32_t(run) ? static_cast<int>(rest) : run;
      int32_t near[run];
      Lanes<run>{}.each([&](int k) WEFT_LANE {
        const Vec3<T> spot = load(spots, q0 + k);
        const Vec3<T> way = horizon * (load(drifts, q0 + k) - mean);
        const T reach = own + radii[q0 + k];
        const bool above_x = spot.x + larger(way.x, zero) >= low.x - reach;
        const bool below_x = spot.x + smaller(way.x, zero) <= high.x + reach;
        const bool above_y = spot.y + larger(way.y, zero) >= low.y - reach;
        const bool below_y = spot.y + smaller(way.y, zero) <= high.y + reach;
        const bool above_z = spot.z + larger(way.z, zero) >= low.z - reach;
        const bool below_z = spot.z + smaller(way.z, zero) <= high.z + reach;
        near[k] = (above_x & below_x & above_y & below_y & above_z & below_z) ? 1 : 0;
      });
      if (n + run > most_kept) {
        compare(c, all, kept, n, candidate);
        n = 0;
      }
      for (int k = 0; k < real; ++k) {
        kept[n] = q0 + k;
        n += near[k];
      }
    }
    return n;
  }

  template <int G, class Candidate>
  WEFT_HD_COLD static void compare(const Contacts<T>& c, const Group<G>& all, const int32_t* kept,
                                   int n, const Candidate& candidate) {
    const T horizon = all.horizon, horizon2 = horizon * horizon;
    const Vec3Array<T> spots = c.spot, drifts = c.drift_of_spot;
    const T* radii = c.radius_of_spot;
    const uint32_t* elements = c.element;
    const LaneVec3<T, G> own = all.spot, own_drift = all.drift;  // loops read locals only
    T own_radius[G];
    for (int l = 0; l < G; ++l) own_radius[l] = all.radius[l];
    for (int from = 0; from < n; from += chunk) {
      alignas(64) T excess[chunk][G];
      WEFT_UNROLL
      for (int k = 0; k < chunk; ++k) {
        const int q = kept[from + k < n ? from + k : from];
        const Vec3<T> spot = load(spots, q), drift = load(drifts, q);
        const T radius = from + k < n ? radii[q] : nobody();
        const int self = static_cast<int>(elements[q]) - all.first;
        Lanes<G>{}.each([&](int l) WEFT_LANE {
          // |d + t v|^2 - reach^2 at the start, at the end and, times v^2, where it is least.
          const Vec3<T> d = spot - own.get(l), v = drift - own_drift.get(l);
          const T reach = larger(radius + own_radius[l], T(0));
          const T dv = dot(d, v), v2 = dot(v, v);
          const T at_start = dot(d, d) - T(1.00001) * (reach * reach);
          const T at_end = at_start + (T(2) * horizon * dv + horizon2 * v2);
          const T between = at_start * v2 - dv * dv;
          const bool passes = (dv < T(0)) & (dv + horizon * v2 > T(0));
          const T least = smaller(smaller(at_start, at_end), passes ? between : T(1));
          const T of_other = reach > T(0) ? least : T(1);
          excess[k][l] = l == self ? T(1) : of_other;
        });
      }
      const bool any = Lanes<G>{}.any([&](int l) WEFT_LANE {
        return smaller(smaller(excess[0][l], excess[1][l]), smaller(excess[2][l], excess[3][l])) <
               T(0);
      });
      if (!any) continue;
      int hits[chunk * G + 1], found = 0;
      for (int k = 0; k < chunk; ++k) {
        for (int l = 0; l < G; ++l) {
          hits[found] = k * G + l;
          found += ((excess[k][l] < T(0)) & (from + k < n)) ? 1 : 0;
        }
      }
      for (int h = 0; h < found; ++h) candidate(hits[h] % G, kept[from + hits[h] / G]);
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
