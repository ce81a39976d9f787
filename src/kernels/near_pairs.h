// The list of pairs that are near, or may come near while it lasts.
//
// Complete: every pair that will be nearer than its distance lies in neighbouring cells, whose
// edges are as long as that distance and all that particles may drift apart meanwhile. The 27 cells
// around a particle are nine runs of the sorted order, since cells along x follow each other.
#pragma once

#include "kernels/cells.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Whether particles i and j, of cloths `a` and `b`, touch when they are near enough.
template <class T>
WEFT_HD bool may_meet(const Contacts<T>& c, int i, int j, int a, int b) {
  if (i == j) return false;
  const ContactCloth &one = c.cloth[a], &other = c.cloth[b];
  if (a != b) {
    return (one.others & other.others) != 0 && (one.layers & other.layers) != 0;
  }
  if (one.itself == 0) return false;
  if (c.with_excluded != 0) return true;
  const double* p = c.rest + 3 * int64_t(i);
  const double* q = c.rest + 3 * int64_t(j);
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return !((x * x + y * y) + z * z < one.distance * one.distance);
}

/// Rows of the list are written by what all kinds of search have in common: `Finder::search(i,
/// emit)` names candidates, each once.
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
    int32_t kept[N][most_kept];
    int32_t count[N], foreign[N], most[N];
    lanes.each_alone([&](int l) {
      int n = 0;
      int32_t other = 0;
      if (i0 + l < end) {
        finder.search(sim, i0 + l, of_cloth, [&](int32_t j, int cloth_of_j) {
          if (n < most_kept) kept[l][n] = j;
          other |= cloth_of_j != of_cloth ? 1 : 0;
          ++n;
        });
      }
      count[l] = n;
      most[l] = n;
      foreign[l] = other;
    });
    finder.remember(sim, i0, lanes);
    const int width = WEFT_OF_FIRST_LANE(largest_of_lanes(most, lanes));
    const int any_foreign = WEFT_OF_FIRST_LANE(largest_of_lanes(foreign, lanes));
    unsigned long long start = 0;
    const auto wanted = static_cast<unsigned long long>(width) * block_size;
    if (lane0 == 0 && width > 0) start = atomic_take(&c.state->used, wanted);
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
      int n = 0;
      if (count[l] <= most_kept) {
        for (; n < count[l]; ++n) row[int64_t(n) * block_size] = kept[l][n];
      } else {
        finder.search(sim, i0 + l, of_cloth,
                      [&](int32_t j, int) { row[int64_t(n++) * block_size] = j; });
      }
      sort_row(c.rank, row, n);
      for (; n < width; ++n) row[int64_t(n) * block_size] = i0 + l;
    });
  }

 private:
  /// By ascending rank.
  WEFT_HD static void sort_row(const uint32_t* rank, int32_t* row, int n) {
    if (n > most_kept) return heap_sort(rank, row, n);
    for (int k = 1; k < n; ++k) {
      const int32_t entry = row[int64_t(k) * block_size];
      int to = k;
      for (; to > 0 && rank[row[int64_t(to - 1) * block_size]] > rank[entry]; --to) {
        row[int64_t(to) * block_size] = row[int64_t(to - 1) * block_size];
      }
      row[int64_t(to) * block_size] = entry;
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
      if (child + 1 < n && rank[row[int64_t(child + 1) * block_size]] >
                               rank[row[int64_t(child) * block_size]]) {
        ++child;
      }
      if (rank[row[int64_t(child) * block_size]] <= rank[entry]) break;
      row[int64_t(k) * block_size] = row[int64_t(child) * block_size];
      k = child;
    }
    row[int64_t(k) * block_size] = entry;
  }
};

/// Every pair that the list must hold.
template <class T, bool Position>
struct CompleteFinder {
  ParticleBuffers<T> p;
  Vec3Array<T> x;

  template <class Emit>
  WEFT_HD void search(const Simulation<T>& sim, int i, int of_cloth, Emit emit) const {
    const Contacts<T>& c = sim.contacts;
    const ContactState& state = *c.state;
    const ContactCloth& cloth = c.cloth[of_cloth];
    const Vec3<T> at = load(x, i);
    const T zero = (at.x - at.x) + (at.y - at.y) + (at.z - at.z);
    if (!(zero == T(0))) return;
    const uint32_t cx = cell_along(state, 0, at.x, cloth.origin[0]);
    const uint32_t cy = cell_along(state, 1, at.y, cloth.origin[1]);
    const uint32_t cz = cell_along(state, 2, at.z, cloth.origin[2]);
    const Vec3<T> spot{T(in_world(at.x, cloth.origin[0]) - state.low[0]),
                       T(in_world(at.y, cloth.origin[1]) - state.low[1]),
                       T(in_world(at.z, cloth.origin[2]) - state.low[2])};
    const bool lasts = state.horizon > 0;
    const Vec3<T> drift = select(lasts, displacement<Position>(p, i), Vec3<T>{T(0), T(0), T(0)});
    const T radius = T(0.5 * (cloth.distance + state.slack) + (lasts ? c.skin : 0.0));
    const Look look{spot, drift, radius, T(state.horizon)};
    const auto candidate = [&](int at_sorted) {
      const auto j = static_cast<int32_t>(c.element[at_sorted]);
      const int of_j = c.cloth_of_spot[at_sorted];
      if (may_meet(c, i, j, of_cloth, of_j)) emit(j, of_j);
    };
    const uint32_t left = (cx - 1u) & state.mask[0], right = (cx + 1u) & state.mask[0];
    for (uint32_t dz = 0; dz < 3; ++dz) {
      for (uint32_t dy = 0; dy < 3; ++dy) {
        const uint32_t row = ((cy + dy - 1u) & state.mask[1]) << state.shift[1] |
                             ((cz + dz - 1u) & state.mask[2]) << state.shift[2];
        if (left <= right) {
          scan(c, look, c.cell_start[row | left], c.cell_start[(row | right) + 1u], candidate);
        } else {  // around the end
          scan(c, look, c.cell_start[row], c.cell_start[(row | right) + 1u], candidate);
          scan(c, look, c.cell_start[row | left], c.cell_start[(row | state.mask[0]) + 1u],
               candidate);
        }
      }
    }
  }

  /// Where the particles are now, and how they go on from here.
  template <int N>
  WEFT_HD void remember(const Simulation<T>& sim, int i0, Lanes<N> lanes) const {
    if (sim.contacts.state->horizon == 0) return;
    const ParticleBuffers<T> buffers = p;
    const Vec3Array<T> now = x, from = sim.contacts.from, drift = sim.contacts.drift;
    lanes.each([=](int l) WEFT_LANE {
      store(from, i0 + l, load(now, i0 + l));
      store(drift, i0 + l, displacement<Position>(buffers, i0 + l));
    });
  }

 private:
  /// What a particle looks for: all that come nearer than the radii of both while both drift.
  struct Look {
    Vec3<T> spot, drift;
    T radius, horizon;
  };

  template <class Candidate>
  WEFT_HD static void scan(const Contacts<T>& c, const Look& look, uint32_t begin, uint32_t end,
                           const Candidate& candidate) {
    constexpr int chunk = 16;
    const Vec3Array<T> spots = c.spot, drifts = c.drift_of_spot;
    const T* radii = c.radius_of_spot;
    for (uint32_t from = begin; from < end; from += chunk) {
      const int first = static_cast<int>(from), count = static_cast<int>(end - from);
      int32_t near[chunk];
      int found = 0;
      WEFT_SIMD_OR(found)
      for (int k = 0; k < chunk; ++k) {
        const Vec3<T> d = load(spots, first + k) - look.spot;
        const Vec3<T> v = load(drifts, first + k) - look.drift;
        const T reach = look.radius + radii[first + k];
        const T v2 = dot(v, v), nearing = -dot(d, v);
        // The time of the least distance, of the substeps that the list is made for.
        const T time = v2 > T(0) ? nearing / v2 : T(0);
        const T in_time = smaller(larger(time, T(0)), look.horizon);
        const Vec3<T> least = d + in_time * v;
        near[k] = (k < count) & (dot(least, least) < reach * reach) ? 1 : 0;
        found |= near[k];
      }
      if (found == 0) continue;
      const int real = count < chunk ? count : chunk;
      for (int k = 0; k < real; ++k) {
        if (near[k] != 0) candidate(first + k);
      }
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
