// Numbers of springs and triangles of the grid stencils; 12n^2 - 28n + 20 directed for seed12.
#include "reference/grid.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

uint64_t directed(TestWorld& test, uint32_t rows, uint32_t columns, weft::Stencil stencil) {
  weft::GridDesc grid;
  grid.rows = rows;
  grid.columns = columns;
  grid.stencil = stencil;
  return 2 * test.cook(grid).spring_count();
}

TEST(SpringCount, Seed12IsThePublishedNumber) {
  struct Count {
    uint32_t n;
    uint64_t directed;
  };
  TestWorld test;
  for (const Count count :
       {Count{1, 0}, Count{2, 12}, Count{3, 44}, Count{4, 100}, Count{8, 564}, Count{16, 2644},
        Count{32, 11412}, Count{64, 47380}, Count{128, 193044}, Count{256, 779284}}) {
    EXPECT_EQ(directed(test, count.n, count.n, weft::Stencil::seed12), count.directed) << count.n;
    if (count.n > 1) {
      EXPECT_EQ(12u * count.n * count.n - 28u * count.n + 20u, count.directed);
    }
  }
}

TEST(SpringCount, OtherStencilsAt32) {
  TestWorld test;
  EXPECT_EQ(directed(test, 32, 32, weft::Stencil::classic12), 11652u);
  EXPECT_EQ(directed(test, 32, 32, weft::Stencil::tri6), 5890u);
  EXPECT_EQ(directed(test, 32, 32, weft::Stencil::quad4), 4u * 32 * 31);
}

TEST(SpringCount, EveryShapeOfGridAgreesWithItsList) {
  TestWorld test;
  for (weft::Stencil stencil :
       {weft::Stencil::seed12, weft::Stencil::classic12, weft::Stencil::quad4, weft::Stencil::tri6})
    for (uint32_t rows : {1u, 2u, 3u, 5u, 33u})
      for (uint32_t columns : {1u, 2u, 3u, 4u, 31u, 32u, 65u})
        EXPECT_EQ(directed(test, rows, columns, stencil),
                  2 * reference::grid_springs(rows, columns, offsets(stencil), 1).size())
            << weft::to_string(stencil) << ' ' << rows << " x " << columns;
}

TEST(SpringCount, StatsAndCheckAgree) {
  TestWorld test;
  weft::GridDesc grid;
  grid.rows = grid.columns = 32;
  test.add(grid, weft::ClothDesc{});
  EXPECT_EQ(2 * test.world().stats().springs, 11412u);
  EXPECT_EQ(test.world().stats().particles, 1024u);
}

TEST(TriangleCount, QuadsAreSplitAlongOneOne) {
  TestWorld test;
  weft::GridDesc grid;
  grid.rows = 3;
  grid.columns = 4;
  const weft::Fabric fabric = test.cook(grid);
  ASSERT_EQ(fabric.triangle_count(), 12u);
  std::vector<uint32_t> corners(36);
  test.check(fabric.read_triangles(0, 12, corners.data()));
  for (int t = 0; t < 12; ++t) {
    // Each triangle holds the ends (r, c) and (r+1, c+1) of its quad's diagonal.
    uint32_t lowest = corners[size_t(3 * t)], highest = lowest;
    for (int e = 1; e < 3; ++e) {
      lowest = std::min(lowest, corners[size_t(3 * t + e)]);
      highest = std::max(highest, corners[size_t(3 * t + e)]);
    }
    EXPECT_EQ(highest, lowest + 5) << t;
  }
}

TEST(SpringCount, MeshHasOneSpringPerEdgeAndPerHinge) {
  // Two triangles of a square and a third on their common edge.
  const std::vector<weft::double3> x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  const std::vector<uint32_t> square{0, 1, 2, 0, 2, 3}, fan{0, 1, 2, 0, 2, 3, 0, 2, 4};
  TestWorld test;
  weft::MeshDesc mesh;
  mesh.positions = weft::View<weft::double3>(x);
  mesh.indices = square;
  EXPECT_EQ(test.cook(mesh).spring_count(), 5u);
  mesh.bend = true;
  EXPECT_EQ(test.cook(mesh).spring_count(), 6u);  // and 1-3
  mesh.indices = fan;                             // an edge with three triangles has no hinge
  EXPECT_EQ(test.cook(mesh).spring_count(), 7u);
}

TEST(SpringCount, NetworkMergesASpringListedTwice) {
  const std::vector<weft::double3> x{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::vector<weft::Spring> springs{{0, 1}, {1, 2}, {1, 0}, {0, 1, 500, 0.25}};
  TestWorld test;
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(x);
  network.springs = springs;
  const weft::Fabric fabric = test.cook(network);
  EXPECT_EQ(fabric.spring_count(), 2u);
  ASSERT_GE(fabric.diagnostics().count, 1u);
  EXPECT_EQ(fabric.diagnostics()[0].element, 2u);
  const std::string text = fabric.diagnostics()[0].text;
  for (const char* word : {"2", "0", "1", "merged"})
    EXPECT_NE(text.find(word), std::string::npos) << text;
}

TEST(SpringCount, MergedSpringPullsOnce) {
  const std::vector<weft::double3> x{{0, 0, 0}, {1.25, 0, 0}};
  const std::vector<weft::Spring> springs{{0, 1, 100, 1}, {1, 0, 100, 1}};
  TestWorld test(plain_world(weft::Precision::float64));
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(x);
  network.springs = springs;
  network.material.mass.value = 2;
  const weft::ClothId cloth = test.add(network, weft::ClothDesc{});
  EXPECT_NEAR(test.accelerations(cloth)[0].x, 25, 1e-12);
}

}  // namespace
}  // namespace weft_tests
