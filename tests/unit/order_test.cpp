#include <algorithm>
#include <cstdint>
#include <numeric>

#include <gtest/gtest.h>

#include "reference/random.h"

#include "scene/fabric.h"

namespace weft::scene {
namespace {

/// A band graph of mixed valence whose vertices carry shuffled numbers.
CookedFabric shuffled_network(uint32_t vertices) {
  reference::SplitMix random(5);
  std::vector<uint32_t> name(vertices);
  std::iota(name.begin(), name.end(), 0u);
  for (uint32_t i = vertices - 1; i > 0; --i) std::swap(name[i], name[random.bits() % (i + 1)]);
  std::vector<double3> positions(vertices);
  for (uint32_t i = 0; i < vertices; ++i) positions[name[i]] = {double(i), 0, 0};
  std::vector<Spring> springs;
  for (uint32_t i = 0; i < vertices; ++i) {
    const auto valence = static_cast<uint32_t>(1 + random.bits() % 6);
    for (uint32_t k = 1; k <= valence && i + k < vertices; ++k)
      springs.push_back({name[i], name[i + k]});
  }
  NetworkDesc desc;
  desc.positions = View<double3>(positions);
  desc.springs = springs;
  CookedFabric fabric(std::pmr::new_delete_resource());
  cook_network(desc, fabric);
  return fabric;
}

TEST(Order, RowsAreSymmetricAndAscendInCallerIndex) {
  const CookedFabric f = shuffled_network(5000);
  EXPECT_EQ(f.rows.neighbour.size(), 2 * f.springs);
  for (uint32_t v = 0; v < f.vertices; ++v) {
    const auto begin = f.rows.neighbour.begin() + static_cast<std::ptrdiff_t>(f.rows.start[v]);
    const auto end = f.rows.neighbour.begin() + static_cast<std::ptrdiff_t>(f.rows.start[v + 1]);
    EXPECT_TRUE(std::is_sorted(begin, end));
    EXPECT_EQ(std::adjacent_find(begin, end), end);
    for (auto n = begin; n != end; ++n) {
      const auto first = f.rows.neighbour.begin() + static_cast<std::ptrdiff_t>(f.rows.start[*n]);
      const auto last =
          f.rows.neighbour.begin() + static_cast<std::ptrdiff_t>(f.rows.start[*n + 1]);
      EXPECT_TRUE(std::binary_search(first, last, v));
    }
  }
}

TEST(Order, StorageIsAPermutation) {
  const CookedFabric f = shuffled_network(3000);
  std::vector<uint32_t> sorted(f.caller_of.begin(), f.caller_of.end());
  std::sort(sorted.begin(), sorted.end());
  for (uint32_t i = 0; i < f.vertices; ++i) {
    EXPECT_EQ(sorted[i], i);
    EXPECT_EQ(f.storage_of[f.caller_of[i]], i);
  }
}

TEST(Order, SlicesWasteLittleAndNeighboursLieNear) {
  const CookedFabric f = shuffled_network(20000);
  const double entries = double(f.slice_start.back());
  EXPECT_LE(entries / double(f.rows.neighbour.size()), 1.05);
  double distance = 0;
  for (uint32_t v = 0; v < f.vertices; ++v) {
    for (uint64_t e = f.rows.start[v]; e < f.rows.start[v + 1]; ++e) {
      distance += std::abs(double(f.storage_of[v]) - double(f.storage_of[f.rows.neighbour[e]]));
    }
  }
  // Shuffled numbers are 6667 apart on average; the valence windows are 1024 wide.
  EXPECT_LE(distance / double(f.rows.neighbour.size()), 700);
}

}  // namespace
}  // namespace weft::scene
