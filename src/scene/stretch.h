// How far the springs of a cloth are stretched, looked at a few at a time.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene/each_spring.h"

namespace weft::scene {

/// Edges of triangles where a fabric has some, else springs by their first vertex; no bend springs,
/// whose length changes where nothing is stretched.
inline uint64_t stretch_items(const CookedFabric& fabric) {
  return fabric.triangles.empty() ? fabric.vertices : fabric.triangles.size() / 3;
}

/// Calls use(i, j, rest length) for the springs of some items.
template <class Use>
void each_stretch(const CookedFabric& fabric, uint64_t first, uint64_t end, Use use) {
  const auto rest_of = [&](uint32_t i, uint32_t j, double rest) {
    if (rest >= 0) return rest;
    const double3 a = fabric.position_of(i), b = fabric.position_of(j);
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return std::sqrt(x * x + y * y + z * z);
  };
  if (!fabric.triangles.empty()) {
    for (uint64_t t = first; t < end; ++t) {
      const uint32_t* corner = fabric.triangles.data() + 3 * t;
      for (int k = 0; k < 3; ++k) {
        const uint32_t i = corner[k], j = corner[(k + 1) % 3];
        use(i, j, rest_of(i, j, fabric.rest_length));
      }
    }
    return;
  }
  each_spring(fabric, static_cast<uint32_t>(first), static_cast<uint32_t>(end),
              [&](uint32_t i, uint32_t j, double, double rest) {
                if (fabric.is_grid && are_two_apart(fabric.grid, i, j)) return;
                use(i, j, rest_of(i, j, rest));
              });
}

/// m: springs between vertices in one place, as at the poles of a globe, have a rest length of
/// rounding errors, and no stretch to speak of.
inline double least_rest(const CookedFabric& fabric) {
  double longest = 0;
  each_stretch(fabric, 0, stretch_items(fabric),
               [&](uint32_t, uint32_t, double rest) { longest = std::max(longest, rest); });
  return 1e-9 * longest;
}

struct Stretches {
  double largest = 0;  ///< (l - l0)/l0
  uint32_t a = 0, b = 0;
  double length = 0, rest = 0;                  ///< m, of that spring
  double longer_squares = 0, rest_squares = 0;  ///< m^2: sums of (l - l0)^2 and of l0^2
};
/// Adds the springs of some items at the positions position(vertex).
template <class Position>
void add_stretches(const CookedFabric& fabric, uint64_t first, uint64_t end, double hair,
                   Position position, Stretches& sum) {
  each_stretch(fabric, first, end, [&](uint32_t i, uint32_t j, double rest) {
    if (!(rest > hair)) return;
    const double3 a = position(i), b = position(j);
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    const double length = std::sqrt(x * x + y * y + z * z), longer = length - rest;
    sum.longer_squares += longer * longer;
    sum.rest_squares += rest * rest;
    if (longer <= sum.largest * rest) return;
    sum.largest = longer / rest;
    sum.a = i;
    sum.b = j;
    sum.length = length;
    sum.rest = rest;
  });
}

}  // namespace weft::scene
