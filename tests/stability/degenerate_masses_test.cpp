// Masses that are zero, infinite or very unequal, and vertices without springs (HC11, HC20 to
// HC22).
#include "reference/closed_forms.h"
#include "reference/networks.h"
#include "reference/refusals.h"

namespace weft_tests {
namespace {

using Masses = BothPrecisions;

TEST_P(Masses, ZeroIsRefusedWithItsVertex) {
  TestWorld test(plain_world(GetParam()));
  const std::vector<weft::double3> x{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(x);
  network.material.mass.kind = weft::Mass::Kind::per_vertex;
  for (double bad : {0.0, -1.0, not_a_number}) {
    const std::vector<double> masses{1, 1, bad};
    network.material.mass.values = masses;
    expect_refusal(test, test.context().cook(network).status(), {"mass", "2"});
  }
}

TEST_P(Masses, InfiniteIsImmobileBitForBitAsAPin) {
  uint64_t hashes[2];
  for (const bool pinned : {false, true}) {
    TestWorld test(plain_world(GetParam()));
    NetworkParts parts;
    parts.positions = {{0.3, 0.1, 0}, {1.25, 0, 0}};
    parts.springs = {{0, 1, 100, 1}};
    parts.masses = {pinned ? 1.0 : infinity, 1};
    if (pinned) parts.pins = {0};
    const weft::ClothId cloth = add_network(test, parts);
    const Vec before = test.position(cloth, 0);
    for (int n = 0; n < 200; ++n) test.step(0.01);
    expect_near(test.position(cloth, 0), before, 0);
    EXPECT_TRUE(std::isfinite(test.take(test.world().mechanics()).kinetic));
    hashes[pinned] = test.hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST_P(Masses, PinIsImmobileWhateverItsMass) {
  uint64_t hashes[2];
  for (int heavy = 0; heavy < 2; ++heavy) {
    TestWorld test(plain_world(GetParam()));
    NetworkParts parts;
    parts.positions = {{0, 0, 0}, {1.25, 0, 0}};
    parts.springs = {{0, 1, 100, 1}};
    parts.masses = {heavy ? 1e17 : 1e-3, 1};
    parts.pins = {0};
    const weft::ClothId cloth = add_network(test, parts);
    test.step(0.01, 300);
    EXPECT_TRUE(same_bits(test.position(cloth, 0), Vec{0, 0, 0}));
    hashes[heavy] = test.hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST_P(Masses, VertexWithoutSpringsFallsFreely) {
  NetworkParts parts;
  parts.positions = {{0, 0, 0}, {1.25, 0, 0}, {0, 0, 0}, {7, 0, 0}};
  parts.springs = {{0, 1, 100, 1}};
  parts.masses = {1, 1, 3, 0.001};
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -9.81, 0};
  TestWorld test(desc);
  const weft::ClothId cloth = add_network(test, parts);
  test.step(0.01, 100);
  const std::vector<Vec> x = test.positions(cloth);
  for (uint32_t i : {2u, 3u}) {
    EXPECT_NEAR(x[i].y, -4.905, tolerance(GetParam(), 4.905));
    EXPECT_EQ(x[i].x, i == 2 ? 0.0 : 7.0);
  }
}

TEST_P(Masses, RatioOfAMillionOscillatesAtItsFrequency) {
  const double k = 100, heavy = 1e6, light = 1, l0 = 1, stretched = 1.25;
  NetworkParts pair;
  pair.positions = {{0, 0, 0}, {stretched, 0, 0}};
  pair.springs = {{0, 1, k, l0}};
  pair.masses = {heavy, light};
  weft::WorldDesc desc = plain_world(GetParam());
  TestWorld test(desc);
  const weft::ClothId cloth = add_network(test, pair);
  const double w = std::sqrt(k * (1 / heavy + 1 / light)), dt = 0.01;
  for (int n = 100; n <= 1000; n += 100) {
    test.step(dt, 100);
    const std::vector<Vec> x = test.positions(cloth);
    const double l = l0 + reference::oscillator(stretched - l0, 0, w, dt, n);
    EXPECT_NEAR(x[1].x - x[0].x, l, tolerance(GetParam(), l)) << n;
    EXPECT_NEAR((heavy * x[0].x + light * x[1].x) / (heavy + light), stretched / (heavy + light),
                tolerance(GetParam(), 1))
        << n;
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, Masses, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
