// Springs of length zero, without rest length, without stiffness, or mirrored (HC01 to HC06, HC24,
// HC37).
#include "reference/networks.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

using Degenerate = BothPrecisions;

TEST_P(Degenerate, SpringOfLengthZeroPullsNothing) {
  const double k = 100, l0 = 0.1, m = 0.5;
  NetworkParts parts;
  parts.positions = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {3, 0, 0}, {4.25, 0, 0}};
  parts.springs = {{0, 1, k, l0}, {2, 3, k, 1}};
  parts.masses = {m};
  parts.pins = {0};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = add_network(test, parts);
  EXPECT_TRUE(same_bits(test.accelerations(cloth)[1], Vec{0, 0, 0}));
  test.step(0.01, 100);
  std::vector<Vec> x = test.positions(cloth);
  ASSERT_TRUE(all_finite(x));
  EXPECT_TRUE(same_bits(x[0], Vec{0.5, 0.5, 0.5}));
  EXPECT_TRUE(same_bits(x[1], Vec{0.5, 0.5, 0.5}));
  // The others do not notice.
  NetworkParts alone = parts;
  alone.springs = {{2, 3, k, 1}};
  TestWorld other(plain_world(GetParam()));
  const weft::ClothId pair = add_network(other, alone);
  other.step(0.01, 100);
  const std::vector<Vec> y = other.positions(pair);
  EXPECT_TRUE(same_bits(x[2], y[2]));
  EXPECT_TRUE(same_bits(x[3], y[3]));
}

TEST_P(Degenerate, CollapsedSpringUnderGravityStaysFiniteAndWeak) {
  const double k = 100, l0 = 0.1, m = 0.5, g = 9.81;
  NetworkParts parts;
  parts.positions = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}};
  parts.springs = {{0, 1, k, l0}};
  parts.masses = {m};
  parts.pins = {0};
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -g, 0};
  TestWorld test(desc);
  const weft::ClothId cloth = add_network(test, parts);
  for (int n = 0; n < 500; ++n) {
    test.step(0.01);
    const double l = length(test.position(cloth, 1) - Vec{0.5, 0.5, 0.5});
    ASSERT_TRUE(std::isfinite(l)) << n;
    const double force = m * length(test.accelerations(cloth)[1] - Vec{0, -g, 0});
    ASSERT_LE(force, k * std::max(l0, l - l0) * 1.001) << n;
  }
}

TEST_P(Degenerate, SpringWithoutRestLengthStaysAtItsAnchor) {
  AnchoredMass mass;
  mass.rest_length = 0;
  mass.start = {0, 0, 0};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  EXPECT_TRUE(same_bits(test.accelerations(cloth)[1], Vec{0, 0, 0}));
  test.step(0.01, 200);
  EXPECT_TRUE(same_bits(test.position(cloth, 1), Vec{0, 0, 0}));
}

TEST_P(Degenerate, SpringWithoutRestLengthIsLinearInSpace) {
  AnchoredMass mass;
  mass.rest_length = 0;
  mass.start = {0.75, -0.5, 1};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  test.step(0.01, 333);
  const double turn = std::cos(333 * 2 * std::asin(0.05));
  expect_near(test.position(cloth, 1), turn * Vec{0.75, -0.5, 1}, tolerance(GetParam(), 1));
}

TEST_P(Degenerate, SheetCollapsedToAPointHasItsWholeEnergy) {
  weft::GridDesc grid;
  grid.rows = grid.columns = 16;
  grid.material.stiffness = 200;
  grid.material.mass.value = 0.25;
  const std::vector<weft::double3> x(256, {0.25, 0.5, 0.75});
  weft::ClothDesc desc;
  desc.positions = weft::View<weft::double3>(x);
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = test.add(grid, desc);
  EXPECT_NEAR(test.mechanics().elastic, 2007.111111111, tolerance(GetParam(), 2007) + 1e-9);
  test.step(1e-4, 50);
  for (Vec p : test.positions(cloth)) ASSERT_TRUE(same_bits(p, Vec{0.25, 0.5, 0.75}));
}

TEST_P(Degenerate, NearlyCollapsedSheetStaysFinite) {
  Sheet sheet;
  sheet.rows = sheet.columns = 16;
  sheet.stiffness = 200;
  sheet.vertex_mass = 0.25 / 256;
  std::vector<weft::double3> x;
  reference::SplitMix random(8);
  for (int i = 0; i < 256; ++i) x.push_back(to_weft(random.noise(1e-6)));
  weft::ClothDesc desc;
  desc.positions = weft::View<weft::double3>(x);
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = test.add(sheet.grid(), desc);
  const double dt = 0.25 * test.world().stability().dt_bound, most = 2027 * std::sqrt(1.25);
  const double energy = test.mechanics().elastic;
  for (int n = 0; n < 40; ++n) {
    test.step(dt, 50);
    for (Vec v : test.velocities(cloth)) ASSERT_LE(length(v), most) << n;
  }
  const weft::Mechanics end = test.mechanics();
  EXPECT_LE(end.kinetic + end.elastic, 1.25 * energy);
}

TEST_P(Degenerate, MirroredSheetIsAtRest) {
  Sheet sheet;
  sheet.rows = sheet.columns = 9;
  std::vector<weft::double3> x;
  for (Vec p : sheet.start()) x.push_back({-p.x, p.y, p.z});
  weft::ClothDesc desc;
  desc.positions = weft::View<weft::double3>(x);
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = test.add(sheet.grid(), desc);
  const double largest = 1e-6 * sheet.stiffness * std::sqrt(8.0) / 8;  // 1e-6 k l0
  for (Vec a : test.accelerations(cloth)) EXPECT_LE(length(a) * sheet.vertex_mass, largest);
}

TEST_P(Degenerate, SpringWithoutStiffnessIsBitwiseNoSpring) {
  NetworkParts with, without;
  with.positions = {{0, 0, 0}, {1.25, 0.5, 0}, {2, 0, 1}, {2, 0, 1}};
  with.masses = {0.75};
  with.pins = {0};
  with.velocities = {{}, {0.5, 0, 0}, {0, 0.25, 0}, {0, 1, 0}};
  without = with;
  without.springs = {{0, 1, 100, 1}, {1, 2, 50, 0.5}};
  // Vertex 3 has only springs without stiffness, one of them of length zero.
  with.springs = {{0, 1, 100, 1}, {1, 2, 50, 0.5}, {1, 3, 0, 1}, {2, 3, 0, 0.5}};
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -9.81, 0};
  TestWorld a(desc), b(desc);
  add_network(a, with);
  add_network(b, without);
  EXPECT_EQ(a.world().stability().dt_bound, b.world().stability().dt_bound);
  for (int n = 0; n < 50; ++n) {
    a.step(0.01, 4);
    b.step(0.01, 4);
    ASSERT_EQ(a.hash(), b.hash()) << n;
  }
}

TEST_P(Degenerate, TinySpringsPullNoMoreThanTheirRestLength) {
  for (double l : {1e-10, 1e-19, 1e-23, 1e-30, 1e-40}) {
    NetworkParts parts;
    parts.positions = {{0, 0, 0}, {1, 0, 0}};
    parts.start = {{0, 0, 0}, {0.6 * l, 0, 0.8 * l}};
    parts.springs = {{0, 1, 100, 0.1}};
    parts.masses = {1};
    parts.pins = {0};
    TestWorld test(plain_world(GetParam()));
    const weft::ClothId cloth = add_network(test, parts);
    const Vec a = test.accelerations(cloth)[1];
    ASSERT_TRUE(reference::finite(a)) << l;
    EXPECT_LE(length(a), 100 * 0.1 * 1.0001) << l;
    test.step(0.01, 10);
    EXPECT_TRUE(all_finite(test.positions(cloth))) << l;
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, Degenerate, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
