// Springs once each, and the springs of each vertex (scene/edges.h).
#include "scene/edges.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "reference/random.h"

#include "scene/each_spring.h"

namespace weft::scene {
namespace {

CookedFabric grid_of(uint32_t rows, uint32_t columns, Stencil stencil) {
  GridDesc desc;
  desc.rows = rows;
  desc.columns = columns;
  desc.stencil = stencil;
  CookedFabric fabric(std::pmr::new_delete_resource());
  cook_grid(desc, fabric);
  return fabric;
}

/// `spokes` of vertex 3, and a random graph among the others.
CookedFabric network_of(uint32_t vertices, uint32_t spokes) {
  reference::SplitMix random(11);
  std::vector<double3> positions;
  for (uint32_t v = 0; v < vertices; ++v) {
    positions.push_back({random.uniform(), random.uniform(), random.uniform()});
  }
  std::vector<Spring> springs;
  for (uint32_t v = 0; v < vertices; ++v) {
    if (v != 3 && v < spokes) springs.push_back({3, v});
    for (int k = 0; k < 3; ++k) {
      const auto other = static_cast<uint32_t>(random.bits() % vertices);
      if (other != v) springs.push_back({v, other});
    }
  }
  NetworkDesc desc;
  desc.positions = View<double3>(positions);
  desc.springs = springs;
  CookedFabric fabric(std::pmr::new_delete_resource());
  cook_network(desc, fabric);
  return fabric;
}

/// Caller indices of the other ends of the springs that entries name for the vertex stored at s.
std::vector<uint32_t> neighbours_of(const CookedFabric& f, const Edges& e, uint32_t s) {
  const auto caller = [&](uint32_t storage) { return f.is_grid ? storage : f.caller_of[storage]; };
  std::vector<int64_t> at;
  for (int64_t k = e.slice_start[s / 32] + s % 32; k < e.slice_start[s / 32 + 1]; k += 32) {
    at.push_back(k);
  }
  for (const HubRow& hub : f.hubs) {
    if (hub.storage != s) continue;
    for (uint32_t k = 0; k < (hub.count + 31) / 32 * 32; ++k) at.push_back(hub.first + k);
  }
  std::vector<uint32_t> out;
  for (const int64_t k : at) {
    const int32_t i = e.incident[size_t(k)];
    if (i == padding(e)) continue;
    const Edge& edge = e.edges[size_t(i < 0 ? ~i : i)];
    EXPECT_EQ(i < 0 ? edge.b : edge.a, s);
    out.push_back(caller(i < 0 ? edge.a : edge.b));
  }
  return out;
}

void expect_whole(const CookedFabric& f) {
  const Edges e = build_edges(f);
  EXPECT_EQ(e.edges.size(), f.springs);
  EXPECT_EQ(int64_t(e.incident.size()), incident_entries(f));
  std::set<std::pair<uint32_t, uint32_t>> expected;
  each_spring(f, [&](uint32_t i, uint32_t j, double, double) {
    expected.insert({i, j});
    expected.insert({j, i});
  });
  std::set<std::pair<uint32_t, uint32_t>> found;
  for (uint32_t s = 0; s < f.vertices; ++s) {
    const std::vector<uint32_t> neighbours = neighbours_of(f, e, s);
    EXPECT_TRUE(std::is_sorted(neighbours.begin(), neighbours.end())) << s;
    const uint32_t v = f.is_grid ? s : f.caller_of[s];
    for (const uint32_t n : neighbours) EXPECT_TRUE(found.insert({v, n}).second) << v << " " << n;
  }
  EXPECT_EQ(found, expected);
}

TEST(Edges, OfGridsAreEveryStencilPairOnce) {
  for (const Stencil s : {Stencil::seed12, Stencil::classic12, Stencil::quad4, Stencil::tri6}) {
    expect_whole(grid_of(9, 13, s));
    expect_whole(grid_of(1, 7, s));
    expect_whole(grid_of(1, 1, s));
  }
}

TEST(Edges, OfNetworksAreEverySpringOnce) {
  expect_whole(network_of(500, 0));
  expect_whole(network_of(3000, 2500));  // vertex 3 is a hub of more than two chunks
}

TEST(Edges, LeaveRoomForOneThatPullsNothing) {
  EXPECT_EQ(padded_edges(0), 32u);
  EXPECT_EQ(padded_edges(31), 32u);
  EXPECT_EQ(padded_edges(32), 64u);
}

TEST(Hubs, LeaveTheirSlices) {
  const CookedFabric f = network_of(3000, 2500);
  ASSERT_EQ(f.hubs.size(), 1u);
  EXPECT_EQ(f.caller_of[f.hubs[0].storage], 3u);
  EXPECT_GE(f.hubs[0].count, 2499u);
  for (size_t s = 0; s + 1 < f.slice_start.size(); ++s) {
    EXPECT_LE(f.slice_start[s + 1] - f.slice_start[s], int64_t(hub_valence) * block_size);
  }
}

TEST(Hubs, RowsUpToTheLimitAreNone) {
  for (const uint32_t spokes : {uint32_t(hub_valence), uint32_t(hub_valence) + 1}) {
    std::vector<double3> positions(spokes + 1, double3{0, 0, 0});
    std::vector<Spring> springs;
    for (uint32_t v = 1; v <= spokes; ++v) springs.push_back({0, v, -1, 1});
    NetworkDesc desc;
    desc.positions = View<double3>(positions);
    desc.springs = springs;
    CookedFabric fabric(std::pmr::new_delete_resource());
    cook_network(desc, fabric);
    EXPECT_EQ(fabric.hubs.size(), spokes > uint32_t(hub_valence) ? 1u : 0u);
  }
}

/// 4 entries per vertex and 2 per spring, and one window of 1024 rows of the largest width:
/// whatever the valences are.
TEST(Hubs, EntriesFollowTheNumberOfSprings) {
  reference::SplitMix random(3);
  for (int round = 0; round < 20; ++round) {
    const auto vertices = static_cast<uint32_t>(1 + random.bits() % 6000);
    std::vector<double3> positions(vertices, double3{0, 0, 0});
    std::vector<Spring> springs;
    for (uint32_t i = 0; i < 4 * vertices; ++i) {
      const double u = random.uniform();
      const auto a = static_cast<uint32_t>(u * u * u * u * u * u * vertices);
      const auto b = static_cast<uint32_t>(random.uniform() * vertices);
      if (a != b) springs.push_back({a, b, -1, 1});
    }
    NetworkDesc desc;
    desc.positions = View<double3>(positions);
    desc.springs = springs;
    CookedFabric fabric(std::pmr::new_delete_resource());
    cook_network(desc, fabric);
    EXPECT_LE(fabric.row_entries, int64_t(4) * vertices + 4096 + 2 * int64_t(fabric.springs) +
                                      32 * int64_t(fabric.hubs.size()));
  }
}

}  // namespace
}  // namespace weft::scene
