// Near pairs by several grids, each shifted against the others: Kipfer, Segal and Westermann 2004;
// Georgii and Westermann 2005, section 5. A particle looks at the `window` particles before and
// behind it in the sorted order of its cell. What no grid has in one cell, or what is further apart
// in the order, is missed: docs/self-collision.md says how much that is.
#pragma once

#include "kernels/near_pairs.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Shift of grid g, in cells, along an axis.
template <class T>
WEFT_HD double shift_of_grid(const Contacts<T>& c, int g, int axis) {
  if (c.diagonal != 0) return static_cast<double>(g) / static_cast<double>(c.grids);
  // {000}, {000,111}, {000,011,101,110}, all eight: bit k of a corner is its half along axis k.
  const int corner = c.grids == 8 ? g : c.grids == 4 ? (g == 0 ? 0 : 7 ^ (1 << (g - 1)))
                                                     : 7 * g;
  return (corner >> axis & 1) != 0 ? 0.5 : 0.0;
}

/// Keys of every grid. 10 or 11 bits of a cell's number along each axis: as many as a key has.
template <class T>
struct StaggeredKeys {
  Simulation<T> sim;
  Vec3Array<T> x;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const Contacts<T>& c = sim.contacts;
    const int i0 = block * block_size + lane0, of_cloth = sim.block.cloth[block];
    const int end = sim.cloths[of_cloth].end;
    const double inverse = 1.0 / c.cell;
    const double ox = c.cloth[of_cloth].origin[0], oy = c.cloth[of_cloth].origin[1];
    const double oz = c.cloth[of_cloth].origin[2];
    const Vec3Array<T> positions = x;
    for (int g = 0; g < c.grids; ++g) {
      uint32_t* key = c.key + int64_t(g) * c.entries_a_grid;
      uint32_t* element = c.element + int64_t(g) * c.entries_a_grid;
      const double sx = shift_of_grid(c, g, 0), sy = shift_of_grid(c, g, 1);
      const double sz = shift_of_grid(c, g, 2);
      lanes.each([=](int l) WEFT_LANE {
        const Vec3<T> at = load(positions, i0 + l);
        const T zero = (at.x - at.x) + (at.y - at.y) + (at.z - at.z);
        const uint32_t kx = floor_bits(in_world(at.x, ox) * inverse - sx) & 0x3ffu;
        const uint32_t ky = floor_bits(in_world(at.y, oy) * inverse - sy) & 0x7ffu;
        const uint32_t kz = floor_bits(in_world(at.z, oz) * inverse - sz) & 0x3ffu;
        const bool real = (i0 + l < end) & (zero == T(0));
        key[i0 + l] = real ? (kz << 21 | ky << 10 | kx) : ~uint32_t(0);
        element[i0 + l] = static_cast<uint32_t>(i0 + l);
      });
    }
  }
};

/// After the sorts: where each particle stands in the order of each grid.
template <class T>
struct StaggeredPlaces {
  Contacts<T> contacts;

  template <int N>
  WEFT_HD void operator()(int block, int lane0, Lanes<N> lanes) const {
    const int p0 = block * block_size + lane0;
    for (int g = 0; g < contacts.grids; ++g) {
      const int64_t first = int64_t(g) * contacts.entries_a_grid;
      lanes.each_alone([&](int l) {
        contacts.place[first + contacts.element[first + p0 + l]] = static_cast<uint32_t>(p0 + l);
      });
    }
  }
};

template <class T>
struct StaggeredFinder {
  Vec3Array<T> x;
  int32_t elements;  ///< of all particles, padding included

  static constexpr int group = 1;

  /// A pair that several grids have acts once: the first of them names it.
  template <int G, class Emit>
  WEFT_HD void search(const Simulation<T>& sim, int i, int, int of_cloth, Emit emit) const {
    const Contacts<T>& c = sim.contacts;
    for (int g = 0; g < c.grids; ++g) {
      const int64_t first = int64_t(g) * c.entries_a_grid;
      const uint32_t* key = c.key + first;
      const auto place = static_cast<int32_t>(c.place[first + i]);
      const uint32_t own = key[place];
      if (own == ~uint32_t(0)) return;
      const auto look = [&](int32_t at) {
        const auto j = static_cast<int32_t>(c.element[first + at]);
        const int of_j = sim.block.cloth[j / block_size];
        if (!is_near(c, i, j, of_cloth, of_j) || !may_meet(c, i, j, of_cloth, of_j)) return;
        for (int before = 0; before < g; ++before) {
          if (has(c, before, i, j)) return;
        }
        emit(0, j, of_j, true);
      };
      const int32_t most = c.window > 0 ? c.window : elements;
      for (int32_t at = place - 1; at >= 0 && place - at <= most && key[at] == own; --at) look(at);
      for (int32_t at = place + 1; at < elements && at - place <= most && key[at] == own; ++at) {
        look(at);
      }
    }
  }
 private:
  /// Whether grid g has the pair.
  WEFT_HD static bool has(const Contacts<T>& c, int g, int i, int j) {
    const int64_t first = int64_t(g) * c.entries_a_grid;
    const auto a = static_cast<int32_t>(c.place[first + i]);
    const auto b = static_cast<int32_t>(c.place[first + j]);
    const int32_t apart = a < b ? b - a : a - b;
    return c.key[first + a] == c.key[first + b] && (c.window == 0 || apart <= c.window);
  }
  /// Nearer than their distance, or than rounding can tell.
  WEFT_HD bool is_near(const Contacts<T>& c, int i, int j, int a, int b) const {
    const ContactCloth &one = c.cloth[a], &other = c.cloth[b];
    const Vec3<T> p = load(x, i), q = load(x, j);
    const double dx = in_world(p.x, one.origin[0]) - in_world(q.x, other.origin[0]);
    const double dy = in_world(p.y, one.origin[1]) - in_world(q.y, other.origin[1]);
    const double dz = in_world(p.z, one.origin[2]) - in_world(q.z, other.origin[2]);
    const double reach = 0.5 * (one.distance + other.distance) * (1.0 + 1e-5);
    return (dx * dx + dy * dy) + dz * dz < reach * reach;
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
