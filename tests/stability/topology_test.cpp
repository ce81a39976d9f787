// Wrong indices, empty and tiny cloths, shared edges (HC09, HC10, HC14, HC16, HC17).
#include "reference/networks.h"
#include "reference/refusals.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

const std::vector<weft::double3> four{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

weft::Status cook_springs(TestWorld& test, const std::vector<weft::Spring>& springs) {
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(four);
  network.springs = springs;
  return test.context().cook(network).status();
}

weft::Status cook_triangles(TestWorld& test, const std::vector<uint32_t>& indices) {
  weft::MeshDesc mesh;
  mesh.positions = weft::View<weft::double3>(four);
  mesh.indices = indices;
  return test.context().cook(mesh).status();
}

TEST(Topology, SpringToItselfIsRefused) {
  TestWorld test;
  EXPECT_EQ(cook_springs(test, {{0, 1}}), weft::Status::ok);
  expect_refusal(test, cook_springs(test, {{0, 1}, {2, 2}}), {"spring", "1", "2"});
}

TEST(Topology, IndexBeyondTheVerticesIsRefused) {
  TestWorld test;
  expect_refusal(test, cook_springs(test, {{0, 1}, {1, 4}}), {"spring", "4"});
  expect_refusal(test, cook_springs(test, {{0xffffffffu, 1}}), {"spring", "4294967295"});
  EXPECT_EQ(cook_triangles(test, {0, 1, 2, 0, 2, 3}), weft::Status::ok);
  expect_refusal(test, cook_triangles(test, {0, 1, 2, 0, 2, 4}), {"triangle", "4"});
  expect_refusal(test, cook_triangles(test, {0xffffffffu, 1, 2}), {"triangle", "4294967295"});
}

TEST(Topology, TriangleWithARepeatedCornerIsRefused) {
  TestWorld test;
  expect_refusal(test, cook_triangles(test, {0, 1, 2, 0, 2, 2}), {"triangle", "1"});
  expect_refusal(test, cook_triangles(test, {0, 0, 2}), {"triangle", "0"});
}

TEST(Topology, IndicesThatAreNoTriangleAreRefused) {
  TestWorld test;
  expect_refusal(test, cook_triangles(test, {0, 1, 2, 0, 2}), {"indices"});
}

TEST(Topology, RefusedFabricLeavesNothing) {
  TestWorld test;
  const uint64_t before = test.context().bytes_allocated();
  for (int i = 0; i < 100; ++i) {
    EXPECT_NE(cook_springs(test, {{0, 1}, {2, 2}}), weft::Status::ok);
    EXPECT_NE(cook_triangles(test, {0, 1, 7}), weft::Status::ok);
  }
  EXPECT_EQ(test.context().bytes_allocated(), before);
}

TEST(Topology, ThreeTrianglesOnOneEdgeHaveSevenEdges) {
  const std::vector<weft::double3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  const std::vector<uint32_t> fan{0, 1, 2, 0, 1, 3, 0, 1, 4};
  TestWorld test;
  weft::MeshDesc mesh;
  mesh.positions = weft::View<weft::double3>(x);
  mesh.indices = fan;
  EXPECT_EQ(test.cook(mesh).spring_count(), 7u);
  const std::vector<uint32_t> bow_tie{0, 1, 2, 0, 3, 4};  // two triangles on one vertex
  mesh.indices = bow_tie;
  EXPECT_EQ(test.cook(mesh).spring_count(), 6u);
}

TEST(Topology, WorldWithoutClothsSteps) {
  for (weft::Precision precision : {weft::Precision::float32, weft::Precision::float64}) {
    TestWorld test(plain_world(precision));
    test.check(test.world().prepare(0.01));
    test.step(0.01, 3);
    EXPECT_NEAR(test.world().time(), 0.03, 1e-15);
    EXPECT_EQ(test.hash(), 0xcbf29ce484222325u);  // of no bytes
    EXPECT_EQ(test.world().stats().particles, 0u);
    const weft::Mechanics m = test.mechanics();
    EXPECT_EQ(m.kinetic + m.elastic + m.potential, 0);
    EXPECT_EQ(test.take(test.world().substeps(0.01)), 1u);
  }
}

TEST(Topology, FabricWithoutVerticesIsAClothThatDoesNothing) {
  TestWorld test(plain_world(weft::Precision::float32));
  const weft::ClothId cloth = test.add(weft::NetworkDesc{}, weft::ClothDesc{});
  EXPECT_TRUE(test.world().valid(cloth));
  test.step(0.01, 3);
  weft::double3 unused{1, 2, 3};
  test.check(test.world().read_positions(cloth, &unused));
  EXPECT_EQ(unused.x, 1);
  EXPECT_EQ(test.hash(), 0xcbf29ce484222325u);
  test.check(test.world().destroy_cloth(cloth));
}

using Tiny = BothPrecisions;

TEST_P(Tiny, GridsOfOneToFourVerticesFallFreely) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, 0, -9.81};
  for (weft::Stencil stencil :
       {weft::Stencil::seed12, weft::Stencil::classic12, weft::Stencil::quad4, weft::Stencil::tri6})
    for (uint32_t rows : {1u, 2u})
      for (uint32_t columns : {1u, 2u, 3u}) {
        TestWorld test(desc);
        weft::GridDesc grid;
        grid.rows = rows;
        grid.columns = columns;
        grid.stencil = stencil;
        const weft::ClothId cloth = test.add(grid, weft::ClothDesc{});
        test.step(0.01, 100);
        for (Vec x : test.positions(cloth))
          EXPECT_NEAR(x.z, -4.905, tolerance(GetParam(), 4.905)) << rows << " x " << columns;
      }
}

TEST_P(Tiny, TriangleFollowsTheReference) {
  const double dt = 0.005;
  reference::System system;
  system.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.25}};
  system.masses.assign(3, 0.1);
  system.pins = {0};
  system.springs = {{0, 1, 100, 0}, {1, 2, 100, 0}, {0, 2, 100, 0}};
  reference::rest_at(system.positions, system.springs);
  system.gravity = {0, -9.81, 0};
  const std::vector<weft::double3> x = to_weft(system.positions);
  const std::vector<uint32_t> indices{0, 1, 2};
  const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}};
  reference::Verlet verlet(system, dt);
  weft::MeshDesc mesh;
  mesh.positions = weft::View<weft::double3>(x);
  mesh.indices = indices;
  mesh.material.mass.value = 0.3;
  weft::ClothDesc desc;
  desc.pins = pins;
  weft::WorldDesc world = plain_world(GetParam());
  world.gravity = {0, -9.81, 0};
  TestWorld test(world);
  const weft::ClothId cloth = test.add(mesh, desc);
  test.step(dt, 150);
  verlet.steps(150);
  const std::vector<Vec> at = test.positions(cloth);
  for (size_t i = 0; i < 3; ++i)
    expect_near(at[i], verlet.positions()[i], tolerance(GetParam(), 1));
}

INSTANTIATE_TEST_SUITE_P(Precision, Tiny, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
