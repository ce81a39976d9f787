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
#include "kernels/collide.h"
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
  int given;  ///< as in PlanCells

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const int i0 = block * block_size + lane0;
    const int of_cloth = sim.block.cloth[block];
    if (lasting) expect(block, i0, lanes);
    const int last = sim.cloths[of_cloth].end - 1;
    const T far = T(3e38);
    const Vec3Array<T> positions = x, drift = sim.contacts.drift;
    const T* skins = sim.contacts.skin_of;
    LaneVec3<T, N> low, high, slow, fast;
    T skin[N];
    lanes.each([&](int l) WEFT_LANE {
      const int i = i0 + l < last ? i0 + l : last;  // padding stands for the last particle
      skin[l] = lasting ? skins[i] : T(0);
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
    box.most_skin = static_cast<double>(largest_of_lanes(skin, lanes));
    if (lane0 == 0) sim.contacts.box[block] = box;
  }

 private:
  /// Whether a collider or other particles may stop what is in the block.
  WEFT_HD bool may_be_stopped(int block) const {
    if (sim.contacts.row_width[block] > 0) return true;
    if (sim.reach == nullptr) return false;
    const ClothActivity<T>& activity = sim.activity[sim.block.cloth[block]];
    return activity.nearness == Nearness::every || !meets_nothing(sim, activity, block);
  }

  /// Who may be stopped gets a skin that it can stop in.
  template <int N>
  WEFT_HD void expect(int block, int i0, Lanes<N> lanes) const {
    const ContactState& state = *sim.contacts.state;
    const T usual = T(sim.contacts.skin);
    const T most = may_be_stopped(block) ? T(sim.contacts.most_stop) : T(0);
    const T ahead = T(given > 0 ? given : state.limit);
    const Vec3<T> calm{T(state.calm[0]), T(state.calm[1]), T(state.calm[2])};
    T* skins = sim.contacts.skin_of;
    const ParticleBuffers<T> buffers = p;
    const Vec3Array<T> now = x, from = sim.contacts.from, drift = sim.contacts.drift;
    if (since < 1) {
      lanes.each([=](int l) WEFT_LANE {
        store(drift, i0 + l, displacement<Position>(buffers, i0 + l));
        store(from, i0 + l, load(now, i0 + l));
        skins[i0 + l] = usual;
      });
      return;
    }
    const T per_substep = T(1) / T(since), age = T(since);
    const T much2 = T(0.25) * usual * usual;
    lanes.each([=](int l) WEFT_LANE {
      const Vec3<T> at = load(now, i0 + l), way = at - load(from, i0 + l);
      const Vec3<T> off = way - age * load(drift, i0 + l);
      const Vec3<T> d = displacement<Position>(buffers, i0 + l);
      // Who was stopped, or pushed, goes on as it does now.
      store(drift, i0 + l, select(dot(off, off) > much2, d, per_substep * way));
      store(from, i0 + l, at);
      const Vec3<T> speed = d - calm;
      skins[i0 + l] = usual + smaller(most, ahead * square_root(dot(speed, speed)));
    });
  }
};

/// Chooses the cells, and for how many substeps a list is made. One block, whose lanes look through
/// the boxes by turns.
template <class T>
struct PlanCells {
  Contacts<T> contacts;
  int blocks;
  bool lasting;  ///< the list is to outlive this substep
  int given;     ///< for so many that the host has chosen; 0: the choice is made here

  template <int N>
  WEFT_HD void operator()(int, int lane0, Lanes<N> lanes) const {
    ContactBox all{};
    for (int axis = 0; axis < 3; ++axis) {
      double low[N], high[N], slowest[N], fastest[N], skin[N];
      lanes.each_alone([&](int l) {
        low[l] = slowest[l] = 1e300;
        high[l] = fastest[l] = -1e300;
        skin[l] = 0.0;
        for (int b = lane0 + l; b < blocks; b += block_size) {
          const ContactBox& box = contacts.box[b];
          low[l] = smaller(low[l], box.low[axis]);
          high[l] = larger(high[l], box.high[axis]);
          slowest[l] = smaller(slowest[l], box.slowest[axis]);
          fastest[l] = larger(fastest[l], box.fastest[axis]);
          skin[l] = larger(skin[l], box.most_skin);
        }
      });
      const double bottom = smallest_of_lanes(low, lanes), top = largest_of_lanes(high, lanes);
      const double slow = smallest_of_lanes(slowest, lanes);
      const double fast = largest_of_lanes(fastest, lanes);
      all.most_skin = largest_of_lanes(skin, lanes);
      all.low[axis] = top >= bottom ? bottom : 0.0;
      all.high[axis] = top >= bottom ? top : 0.0;
      all.slowest[axis] = fast >= slow ? slow : 0.0;
      all.fastest[axis] = fast >= slow ? fast : 0.0;
    }
    if (lane0 != 0) return;
    choose(all, *contacts.state);
  }

 private:
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
    for (int axis = 0; axis < 3; ++axis) {
      state.calm[axis] = smaller(larger(all.slowest[axis], 0.0), all.fastest[axis]);
    }
    if (lasting) {
      const double fits = spread > 0.0 ? contacts.most_drift / spread : 1e9;
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
    const double reach = contacts.most_distance + 2.0 * all.most_skin + state.slack;
    double size[3];
    int bits[3], total = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double apart = double(state.horizon) * (all.fastest[axis] - all.slowest[axis]);
      state.reach[axis] = (reach + apart) * (1.0 + 1e-6);
      state.inverse_zone[axis] = 0.5 / state.reach[axis];
      // As long as the calm need them. Along x a run of cells is looked through at once; across
      // it, larger cells make fewer runs.
      const double calm = contacts.most_distance + 2.0 * skin + state.slack;
      size[axis] = (axis == 0 ? 1.0 : 2.0) * calm;
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

/// Number of a zone along an axis, as far as it is kept; and of the zone.
WEFT_HD uint32_t zone_along(const ContactState& state, int axis, double from_low) {
  return floor_bits(from_low * state.inverse_zone[axis]);
}
WEFT_HD int zone_of(uint32_t x, uint32_t y, uint32_t z) {
  constexpr uint32_t mask = (1u << zone_bits) - 1u;
  return static_cast<int>((x & mask) | (y & mask) << zone_bits | (z & mask) << (2 * zone_bits));
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
      key[i] = ((i < end) & (zero == T(0))) ? of_cell : none;
      element[i] = static_cast<uint32_t>(i);
    });
    if (state.horizon > 0) note_in_zones(state, i0, end, ox, oy, oz, lanes);
  }

 private:
  /// Those that follow each other are mostly in one zone: it hears of them together.
  template <int N>
  WEFT_HD_COLD void note_in_zones(const ContactState& state, int i0, int end, double ox, double oy,
                                  double oz, Lanes<N>) const {
    const Contacts<T>& c = sim.contacts;
    Vec3<T> slow{}, fast{};
    T skin = T(0);
    int at = -1;
    for (int l = 0; l < N && i0 + l < end; ++l) {
      const Vec3<T> position = load(x, i0 + l), drift = load(c.drift, i0 + l);
      const T zero =
          (position.x - position.x) + (position.y - position.y) + (position.z - position.z);
      if (!(zero == T(0))) continue;
      const int zone = zone_of(zone_along(state, 0, in_world(position.x, ox) - state.low[0]),
                               zone_along(state, 1, in_world(position.y, oy) - state.low[1]),
                               zone_along(state, 2, in_world(position.z, oz) - state.low[2]));
      if (zone != at) {
        if (at >= 0) note(c.zone[at], slow, fast, skin);
        at = zone;
        slow = fast = drift;
        skin = c.skin_of[i0 + l];
        continue;
      }
      slow = {smaller(slow.x, drift.x), smaller(slow.y, drift.y), smaller(slow.z, drift.z)};
      fast = {larger(fast.x, drift.x), larger(fast.y, drift.y), larger(fast.z, drift.z)};
      skin = larger(skin, c.skin_of[i0 + l]);
    }
    if (at >= 0) note(c.zone[at], slow, fast, skin);
  }
  WEFT_HD static void note(ContactZone& zone, Vec3<T> slow, Vec3<T> fast, T skin) {
    atomic_least(&zone.slowest[0], ordered(static_cast<double>(slow.x)));
    atomic_least(&zone.slowest[1], ordered(static_cast<double>(slow.y)));
    atomic_least(&zone.slowest[2], ordered(static_cast<double>(slow.z)));
    atomic_most(&zone.fastest[0], ordered(static_cast<double>(fast.x)));
    atomic_most(&zone.fastest[1], ordered(static_cast<double>(fast.y)));
    atomic_most(&zone.fastest[2], ordered(static_cast<double>(fast.z)));
    atomic_most(&zone.most_skin, ordered(static_cast<double>(skin)));
  }
};

/// Zones before anybody is noted in them.
template <class T>
struct ClearZones {
  Contacts<T> contacts;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    lanes.each_alone([&](int l) {
      ContactZone& zone = contacts.zone[block * block_size + lane0 + l];
      for (int axis = 0; axis < 3; ++axis) {
        zone.slowest[axis] = ordered(1e300);
        zone.fastest[axis] = ordered(-1e300);
      }
      zone.most_skin = ordered(0.0);
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
      store(c.drift_of_spot, at, lasts ? load(c.drift, i) : Vec3<T>{T(0), T(0), T(0)});
      const T skin = lasts ? c.skin_of[i] : T(0);
      c.radius_of_spot[at] = T(0.5 * (cloth.distance + state.slack)) + skin;
      c.cloth_of_spot[at] = of_cloth;
    });
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
