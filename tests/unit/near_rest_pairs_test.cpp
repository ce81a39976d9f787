// Pairs that are near at rest against a count of all pairs, and closed forms.
#include "scene/near_rest_pairs.h"

#include "reference/random.h"

#include <gtest/gtest.h>

namespace weft::scene {
namespace {

CookedFabric network_of(const std::vector<double3>& at) {
  CookedFabric fabric(std::pmr::get_default_resource());
  NetworkDesc desc;
  desc.positions = View<double3>(at);
  cook_network(desc, fabric);
  return fabric;
}
CookedFabric grid_of(uint32_t rows, uint32_t columns, double spacing) {
  CookedFabric fabric(std::pmr::get_default_resource());
  GridDesc desc;
  desc.rows = rows;
  desc.columns = columns;
  desc.height = rows > 1 ? spacing * (rows - 1) : 1;
  desc.width = columns > 1 ? spacing * (columns - 1) : 1;
  cook_grid(desc, fabric);
  return fabric;
}

/// By definition.
uint64_t all_pairs(const std::vector<double3>& x, double distance) {
  uint64_t count = 0;
  for (size_t i = 0; i < x.size(); ++i)
    for (size_t j = i + 1; j < x.size(); ++j) {
      const double dx = x[i].x - x[j].x, dy = x[i].y - x[j].y, dz = x[i].z - x[j].z;
      count += dx * dx + dy * dy + dz * dz < distance * distance;
    }
  return count;
}

TEST(NearRestPairs, AreThoseOfAllPairsOnRandomPoints) {
  reference::SplitMix random(3);
  for (const double far : {0.0, 3.0, 1e6})
    for (const size_t n : {0u, 1u, 2u, 16u, 17u, 33u, 900u}) {
      std::vector<double3> x;
      for (size_t i = 0; i < n; ++i) {
        const reference::Vec p = random.noise(0.5);
        x.push_back({p.x + far, p.y - far, (i % 3 == 0 ? 0 : p.z) + far});
        if (i % 7 == 6) x.push_back(x[i / 2]);
      }
      const CookedFabric fabric = network_of(x);
      for (const double distance : {1e-9, 0.01, 0.05, 0.3, 0.9, 2.0}) {
        EXPECT_EQ(near_rest_pairs(fabric, distance), all_pairs(x, distance))
            << n << " points, " << distance << " m at " << far;
      }
    }
}

/// Spacing and distances are powers of two and their halves: no rounding decides.
TEST(NearRestPairs, OfAGridAreStrictlyNearer) {
  const uint64_t rows = 37, columns = 53;
  const CookedFabric grid = grid_of(rows, columns, 0.25);
  const uint64_t beside = rows * (columns - 1) + (rows - 1) * columns;
  const uint64_t across = 2 * (rows - 1) * (columns - 1);
  EXPECT_EQ(near_rest_pairs(grid, 0.25), 0u);
  EXPECT_EQ(near_rest_pairs(grid, 0.2500001), beside);
  EXPECT_EQ(near_rest_pairs(grid, 0.36), beside + across);
  const uint64_t two_on = rows * (columns - 2) + (rows - 2) * columns;
  EXPECT_EQ(near_rest_pairs(grid, 0.5), beside + across);
  EXPECT_EQ(near_rest_pairs(grid, 0.5000001), beside + across + two_on);
  EXPECT_EQ(near_rest_pairs(grid_of(1, 100, 0.25), 0.26), 99u);
}

/// Where all are near, or at one place, no pair is looked at.
TEST(NearRestPairs, OfAMillionAreCountedInNoTime) {
  const uint64_t n = 1 << 20;
  const CookedFabric grid = grid_of(1 << 10, 1 << 10, 0.001);
  EXPECT_EQ(near_rest_pairs(grid, 2), n * (n - 1) / 2);
  EXPECT_EQ(near_rest_pairs(network_of(std::vector<double3>(n, {1, 2, 3})), 1e-9), n * (n - 1) / 2);
}

}  // namespace
}  // namespace weft::scene
