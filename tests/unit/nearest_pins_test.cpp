// Shortest paths against all paths, by Floyd and Warshall.
#include "scene/nearest_pins.h"

#include "reference/mesh_shapes.h"
#include "reference/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace weft::scene {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// Distances between all pairs.
class AllPaths {
 public:
  explicit AllPaths(size_t n) : n_(n), d_(n * n, endless) {
    for (size_t i = 0; i < n; ++i) d_[i * n + i] = 0;
  }
  void edge(size_t i, size_t j, double length) {
    d_[i * n_ + j] = d_[j * n_ + i] = std::min(length, d_[i * n_ + j]);
  }
  void close() {
    for (size_t k = 0; k < n_; ++k)
      for (size_t i = 0; i < n_; ++i)
        for (size_t j = 0; j < n_; ++j)
          d_[i * n_ + j] = std::min(d_[i * n_ + j], d_[i * n_ + k] + d_[k * n_ + j]);
  }
  double operator()(size_t i, size_t j) const { return d_[i * n_ + j]; }

 private:
  size_t n_;
  std::vector<double> d_;
};

NearestPins found_in(const CookedFabric& fabric, const std::vector<uint32_t>& pins) {
  std::pmr::memory_resource* memory = std::pmr::get_default_resource();
  return nearest_pins(fabric, Array<uint32_t>(pins.begin(), pins.end(), memory), memory);
}

void expect_equal(const CookedFabric& fabric, const AllPaths& paths, std::vector<uint32_t> pins) {
  const NearestPins found = found_in(fabric, pins);
  for (uint32_t v = 0; v < fabric.vertices; ++v) {
    double least = endless;
    for (const uint32_t pin : pins) least = std::min(least, paths(pin, v));
    if (!std::isfinite(least)) {
      EXPECT_EQ(found.pin[v], no_pin) << v;
      continue;
    }
    EXPECT_NEAR(found.distance[v], least, 1e-12) << v;
    ASSERT_NE(found.pin[v], no_pin);
    EXPECT_NEAR(paths(found.pin[v], v), least, 1e-12) << v;
  }
}

double distance(const double3& a, const double3& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) +
                   (a.z - b.z) * (a.z - b.z));
}

TEST(NearestPins, OfAGridAreOverNeighboursAndDiagonals) {
  const struct {
    Stencil stencil;
    bool straight, slanted, backward;
  } cases[] = {{Stencil::seed12, true, true, true},
               {Stencil::classic12, true, true, true},
               {Stencil::quad4, true, false, false},
               {Stencil::tri6, true, true, false}};
  for (const auto& c : cases) {
    GridDesc desc;
    desc.rows = 7;
    desc.columns = 9;
    desc.width = 2;
    desc.height = 0.9;
    desc.stencil = c.stencil;
    CookedFabric fabric(std::pmr::get_default_resource());
    cook_grid(desc, fabric);
    AllPaths paths(63);
    const double across = 0.25, up = 0.15, slant = std::hypot(across, up);
    for (size_t r = 0; r < 7; ++r)
      for (size_t k = 0; k < 9; ++k) {
        const size_t v = r * 9 + k;
        if (k < 8) paths.edge(v, v + 1, across);
        if (r < 6) paths.edge(v, v + 9, up);
        if (k < 8 && r < 6 && c.slanted) paths.edge(v, v + 10, slant);
        if (k > 0 && r < 6 && c.backward) paths.edge(v, v + 8, slant);
      }
    paths.close();
    expect_equal(fabric, paths, {0});
    expect_equal(fabric, paths, {8, 31, 62});
  }
}

TEST(NearestPins, OfAMeshAreAlongItsTrianglesAndNotAcrossAFold) {
  // A strip folded over: its bend springs are short, its way is not.
  std::vector<double3> positions;
  std::vector<uint32_t> triangles;
  for (uint32_t i = 0; i < 12; ++i) {
    const double z = i < 6 ? 0 : 0.01, x = i < 6 ? i : 11. - i;
    positions.push_back({x, 0, z});
    positions.push_back({x, 1, z});
    if (i == 0) continue;
    const uint32_t a = 2 * i - 2;
    for (const uint32_t corner : {a, a + 1, a + 2, a + 2, a + 1, a + 3})
      triangles.push_back(corner);
  }
  MeshDesc desc;
  desc.positions = View<double3>(positions);
  desc.indices = triangles;
  desc.bend = true;
  desc.material.stiffness = Stiffness(1, 0, 1);
  CookedFabric fabric(std::pmr::get_default_resource());
  cook_mesh(desc, fabric);
  AllPaths paths(positions.size());
  for (size_t t = 0; t < triangles.size(); t += 3)
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t i = triangles[t + k], j = triangles[t + (k + 1) % 3];
      paths.edge(i, j, distance(positions[i], positions[j]));
    }
  paths.close();
  expect_equal(fabric, paths, {0});
  expect_equal(fabric, paths, {0, 1, 23});
  EXPECT_GT(found_in(fabric, {0}).distance[22], 10);
}

TEST(NearestPins, OfANetworkTakeTheLengthsOfItsSprings) {
  reference::SplitMix random(3);
  std::vector<double3> positions(40);
  std::vector<Spring> springs;
  AllPaths paths(40);
  for (uint32_t i = 0; i < 55; ++i) {
    const uint32_t a = uint32_t(random.uniform() * 36), b = uint32_t(random.uniform() * 36);
    if (a == b) continue;
    bool known = false;
    for (const Spring& s : springs) known |= (s.a == a && s.b == b) || (s.a == b && s.b == a);
    if (known) continue;
    springs.push_back({a, b, 1, 0.1 + random.uniform()});
    paths.edge(a, b, springs.back().rest_length);
  }
  paths.close();
  NetworkDesc desc;
  desc.positions = View<double3>(positions);
  desc.springs = springs;
  CookedFabric fabric(std::pmr::get_default_resource());
  cook_network(desc, fabric);
  expect_equal(fabric, paths, {5});
  expect_equal(fabric, paths, {5, 17, 35, 39});
}

TEST(NearestPins, OfTwoEquallyNearTheFirstCounts) {
  GridDesc desc;
  desc.rows = 1;
  desc.columns = 5;
  CookedFabric fabric(std::pmr::get_default_resource());
  cook_grid(desc, fabric);
  EXPECT_EQ(found_in(fabric, {0, 4}).pin[2], 0u);
  EXPECT_EQ(found_in(fabric, {4, 0}).pin[2], 0u);
  EXPECT_EQ(found_in(fabric, {}).pin[2], no_pin);
}

}  // namespace
}  // namespace weft::scene
