// Particles into the cells of a grid, so that who is near stands near in the sorted order: the
// sorted grids of Kipfer, Segal and Westermann 2004, which Georgii and Westermann 2005, section 5,
// take over.
//
// A particle's cell has whole numbers along each axis; their lowest bits, one axis after the other,
// are its key. So cells wrap around where a world has more of them than keys can tell apart, and
// whoever looks through a cell compares distances anyway.
#pragma once

#include "base/atomic_words.h"
#include "base/lanes.h"
#include "kernels/displacement.h"
#include "state/simulation.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Position in the world, of one axis.
WEFT_HD double in_world(float x, double origin) { return static_cast<double>(x) + origin; }
WEFT_HD double in_world(double x, double origin) { return x + origin; }

/// The lowest 32 bits of floor(v), |v| < 2^51. Whole numbers lie behind each other in doubles of
/// one exponent: adding such a one leaves them in the last bits.
WEFT_HD uint32_t floor_bits(double v) {
  constexpr double magic = 6755399441055744.0;  // 1.5 * 2^52
  const double nearest = (v + magic) - magic;
  const double whole = (nearest > v ? nearest - 1.0 : nearest) + magic;
  uint64_t bits;
  __builtin_memcpy(&bits, &whole, sizeof bits);
  return static_cast<uint32_t>(bits);
}

/// Bounds of where each block is and how it goes on from there; what is not finite does not count.
/// A list that is to last expects a particle to go on as it did on average since the last such list
/// was made, so that what only trembles does not outrun it.
template <class T, bool Position>
struct ContactBounds {
  Simulation<T> sim;
  ParticleBuffers<T> p;
  Vec3Array<T> x;
  bool lasting;
  int since;  ///< substeps since `from` and `drift` were written; below 1: never

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const int i0 = block * block_size + lane0;
    const int of_cloth = sim.block.cloth[block];
    if (lasting) expect(i0, lanes);
    const int last = sim.cloths[of_cloth].end - 1;
    const T far = T(3e38);
    const Vec3Array<T> positions = x, drift = sim.contacts.drift;
    LaneVec3<T, N> low, high, slow, fast;
    lanes.each([&](int l) WEFT_LANE {
      const int i = i0 + l < last ? i0 + l : last;  // padding stands for the last particle
      const Vec3<T> at = load(positions, i), none{T(0), T(0), T(0)};
      const Vec3<T> d = lasting ? load(drift, i) : none;
      const T zero = (at.x - at.x) + (at.y - at.y) + (at.z - at.z);
      const bool finite = zero == T(0);
      const Vec3<T> plus{far, far, far}, minus{-far, -far, -far};
      low.set(l, select(finite, at, plus));
      high.set(l, select(finite, at, minus));
      slow.set(l, select(finite, d, plus));
      fast.set(l, select(finite, d, minus));
    });
    const double* origin = sim.contacts.cloth[of_cloth].origin;
    ContactBox box;
    box.low[0] = in_world(smallest_of_lanes(low.x, lanes), origin[0]);
    box.low[1] = in_world(smallest_of_lanes(low.y, lanes), origin[1]);
    box.low[2] = in_world(smallest_of_lanes(low.z, lanes), origin[2]);
    box.high[0] = in_world(largest_of_lanes(high.x, lanes), origin[0]);
    box.high[1] = in_world(largest_of_lanes(high.y, lanes), origin[1]);
    box.high[2] = in_world(largest_of_lanes(high.z, lanes), origin[2]);
    box.slowest[0] = static_cast<double>(smallest_of_lanes(slow.x, lanes));
    box.slowest[1] = static_cast<double>(smallest_of_lanes(slow.y, lanes));
    box.slowest[2] = static_cast<double>(smallest_of_lanes(slow.z, lanes));
    box.fastest[0] = static_cast<double>(largest_of_lanes(fast.x, lanes));
    box.fastest[1] = static_cast<double>(largest_of_lanes(fast.y, lanes));
    box.fastest[2] = static_cast<double>(largest_of_lanes(fast.z, lanes));
    if (lane0 == 0) sim.contacts.box[block] = box;
  }

 private:
  template <int N>
  WEFT_HD void expect(int i0, Lanes<N> lanes) const {
    const ParticleBuffers<T> buffers = p;
    const Vec3Array<T> now = x, from = sim.contacts.from, drift = sim.contacts.drift;
    if (since < 1) {
      lanes.each([=](int l) WEFT_LANE {
        store(drift, i0 + l, displacement<Position>(buffers, i0 + l));
        store(from, i0 + l, load(now, i0 + l));
      });
      return;
    }
    const T per_substep = T(1) / T(since), age = T(since);
    const T much2 = T(0.25) * T(sim.contacts.skin) * T(sim.contacts.skin);
    lanes.each([=](int l) WEFT_LANE {
      const Vec3<T> at = load(now, i0 + l), way = at - load(from, i0 + l);
      const Vec3<T> off = way - age * load(drift, i0 + l);
      const Vec3<T> d = displacement<Position>(buffers, i0 + l);
      // Who was stopped, or pushed, goes on as it does now.
      store(drift, i0 + l, select(dot(off, off) > much2, d, per_substep * way));
      store(from, i0 + l, at);
    });
  }
};

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

/// Chooses the cells, and for how many substeps a list is made. One block, one lane.
template <class T>
struct PlanCells {
  Contacts<T> contacts;
  int blocks;
  bool lasting;  ///< the list is to outlive this substep
  int given;     ///< for so many that the host has chosen; 0: the choice is made here

  template <int N>
  WEFT_HD void operator()(int, int lane0, Lanes<N>) const {
    if (lane0 != 0) return;
    ContactBox all{};
    for (int axis = 0; axis < 3; ++axis) {
      double low = 1e300, high = -1e300, slowest = 1e300, fastest = -1e300;
      for (int b = 0; b < blocks; ++b) {
        const ContactBox& box = contacts.box[b];
        low = smaller(low, box.low[axis]);
        high = larger(high, box.high[axis]);
        slowest = smaller(slowest, box.slowest[axis]);
        fastest = larger(fastest, box.fastest[axis]);
      }
      all.low[axis] = high >= low ? low : 0.0;
      all.high[axis] = high >= low ? high : 0.0;
      all.slowest[axis] = fastest >= slowest ? slowest : 0.0;
      all.fastest[axis] = fastest >= slowest ? fastest : 0.0;
    }
    choose(all, *contacts.state);
  }

 private:
  /// How far apart particles may drift along an axis while a list lasts, in distances: further, and
  /// cells become larger than what is gained by making lists more rarely.
  static constexpr double most_drift = 2.0;
  static constexpr int longest = 1024;

  WEFT_HD void choose(const ContactBox& all, ContactState& state) const {
    state.used = 0;
    state.lists += 1;
    state.horizon = 0;
    double furthest = 0.0, extent = 0.0, speed = 0.0, spread = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      furthest = larger(furthest, larger(all.high[axis], -all.low[axis]));
      extent = larger(extent, all.high[axis] - all.low[axis]);
      speed = larger(speed, larger(all.fastest[axis], -all.slowest[axis]));
      spread = larger(spread, all.fastest[axis] - all.slowest[axis]);
    }
    if (lasting) {
      const double fits = spread > 0.0 ? most_drift * contacts.most_distance / spread : 1e9;
      int horizon = fits < double(longest) ? static_cast<int>(fits) : longest;
      if (given > 0) {
        if (state.outrun == 0) state.limit = horizon;
        if (horizon < given) state.outrun = 1;  // with cells that large they would all be near
        horizon = horizon < given ? 0 : given;
      } else if (horizon > state.limit) {
        horizon = state.limit;
      }
      if (given == 0 && horizon < 1) {
        state.wait = 8;
        return;
      }
      state.horizon = horizon;
    }
    // Positions in the world, their rounding to `spot`, and the way that a drift makes of them.
    constexpr double unit = sizeof(T) == 4 ? 1.2e-7 : 2.3e-16;
    state.slack = 8.0 * (2.3e-16 * furthest + unit * (extent + double(state.horizon) * speed));
    const double skin = lasting ? contacts.skin : 0.0;
    const double reach = contacts.most_distance + 2.0 * skin + state.slack;
    double size[3];
    int bits[3], total = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double apart = double(state.horizon) * (all.fastest[axis] - all.slowest[axis]);
      size[axis] = (reach + apart) * (1.0 + 1e-6);
      const double cells = (all.high[axis] - all.low[axis]) / size[axis] + 1.0;
      bits[axis] = 2;
      while (bits[axis] < 24 && double(1 << bits[axis]) < cells) ++bits[axis];
      total += bits[axis];
    }
    while (total > contacts.key_bits) {
      int most = 0;
      if (bits[1] > bits[most]) most = 1;
      if (bits[2] > bits[most]) most = 2;
      --bits[most];
      --total;
    }
    // Bits that are left make the first axis wrap more rarely.
    bits[0] += contacts.key_bits - total;
    int shift = 0;
    for (int axis = 0; axis < 3; ++axis) {
      state.low[axis] = all.low[axis];
      state.inverse_cell[axis] = 1.0 / size[axis];
      state.mask[axis] = (uint32_t(1) << bits[axis]) - 1u;
      state.shift[axis] = shift;
      shift += bits[axis];
    }
  }
};

/// A particle's cell along an axis.
template <class T>
WEFT_HD uint32_t cell_along(const ContactState& state, int axis, T x, double origin) {
  const double from_low = in_world(x, origin) - state.low[axis];
  return floor_bits(from_low * state.inverse_cell[axis]) & state.mask[axis];
}

/// Key of every particle; padding and what is not finite gets the largest.
template <class T>
struct CellKeys {
  Simulation<T> sim;
  Vec3Array<T> x;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    const int i0 = block * block_size + lane0, of_cloth = sim.block.cloth[block];
    const int end = sim.cloths[of_cloth].end;
    const ContactState state = *c.state;
    const double ox = c.cloth[of_cloth].origin[0], oy = c.cloth[of_cloth].origin[1];
    const double oz = c.cloth[of_cloth].origin[2];
    const uint32_t none = uint32_t(1) << c.key_bits;
    uint32_t* key = c.key;
    uint32_t* element = c.element;
    const Vec3Array<T> positions = x;
    lanes.each([=](int l) WEFT_LANE {
      const int i = i0 + l;
      const Vec3<T> at = load(positions, i);
      const T zero = (at.x - at.x) + (at.y - at.y) + (at.z - at.z);
      const uint32_t of_cell = cell_along(state, 0, at.x, ox) << state.shift[0] |
                               cell_along(state, 1, at.y, oy) << state.shift[1] |
                               cell_along(state, 2, at.z, oz) << state.shift[2];
      key[i] = (i < end) & (zero == T(0)) ? of_cell : none;
      element[i] = static_cast<uint32_t>(i);
    });
  }
};

/// After the sort: where each cell begins, and the particles in the order of their cells.
template <class T>
struct SortedCells {
  Simulation<T> sim;
  Vec3Array<T> x;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    const ContactState state = *c.state;
    const int p0 = block * block_size + lane0;
    const uint32_t last = (uint32_t(1) << c.key_bits) + 1u;
    lanes.each_alone([&](int l) {
      const int at = p0 + l;
      // The cells between this particle's and the one before it begin here.
      const uint32_t own = c.key[at], before = at == 0 ? 0u : c.key[at - 1] + 1u;
      for (uint32_t k = before; k <= own; ++k) c.cell_start[k] = static_cast<uint32_t>(at);
      if (at + 1 == sim.blocks * block_size) {
        for (uint32_t k = own + 1u; k <= last; ++k) c.cell_start[k] = static_cast<uint32_t>(at + 1);
      }
      const int i = static_cast<int>(c.element[at]);
      const int of_cloth = sim.block.cloth[i / block_size];
      const ContactCloth& cloth = c.cloth[of_cloth];
      const Vec3<T> position = load(x, i);
      store(c.spot, at,
            Vec3<T>{T(in_world(position.x, cloth.origin[0]) - state.low[0]),
                    T(in_world(position.y, cloth.origin[1]) - state.low[1]),
                    T(in_world(position.z, cloth.origin[2]) - state.low[2])});
      const bool lasts = state.horizon > 0;
      store(c.drift_of_spot, at,
            lasts ? load(c.drift, i) : Vec3<T>{T(0), T(0), T(0)});
      c.radius_of_spot[at] = T(0.5 * (cloth.distance + state.slack) + (lasts ? c.skin : 0.0));
      c.cloth_of_spot[at] = of_cloth;
    });
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
