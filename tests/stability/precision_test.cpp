// What float32 must not lose: small increments, places far from the origin, rest (HC32, HC36,
// HC39).
#include "reference/networks.h"
#include "reference/random.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

TEST(Float32, ParticleFallsAtTheSmallestSteps) {
  struct Drop {
    double dt, exact, delta;  // published drops from y = 1.5 after 1 s
  };
  for (const Drop drop :
       {Drop{1.0 / 1000, 4.909905, 4.909922}, Drop{1.0 / 2000, 4.907452, 4.907422},
        Drop{1.0 / 5000, 4.905981, 4.906036}, Drop{1.0 / 10000, 4.905490, 4.905336},
        Drop{1.0 / 20000, 4.905245, 4.905480}}) {
    weft::WorldDesc desc = plain_world(weft::Precision::float32, weft::Start::lagged);
    desc.gravity = {0, -9.81, 0};
    TestWorld test(desc);
    const weft::ClothId cloth = add_particles(test, {{0, 1.5, 0}});
    test.step(drop.dt, int(std::lround(1 / drop.dt)));
    EXPECT_NEAR(1.5 - test.position(cloth, 0).y, drop.exact, 5e-4) << drop.dt;
  }
  weft::WorldDesc desc = plain_world(weft::Precision::float32);
  desc.gravity = {0, -9.81, 0};
  TestWorld test(desc);
  const weft::ClothId cloth = add_particles(test, {{0, 1.5, 0}});
  test.step(1.0 / 20000, 20000);
  EXPECT_NEAR(1.5 - test.position(cloth, 0).y, 4.905, 1e-3);
}

TEST(Float32, PositionFormHovers) {
  // The reason for the summed form, kept as a named mode.
  weft::WorldDesc desc = plain_world(weft::Precision::float32, weft::Start::lagged);
  desc.gravity = {0, -9.81, 0};
  desc.form = weft::Form::position;
  TestWorld test(desc);
  const weft::ClothId cloth = add_particles(test, {{0, 1.5, 0}});
  test.step(1.0 / 20000, 20000);
  EXPECT_EQ(test.position(cloth, 0).y, 1.5);
}

/// The 16 x 16 sheet on four pins after half a second, relative to its place.
std::vector<Vec> hanging_sheet(Vec place, weft::Precision precision) {
  weft::WorldDesc desc = plain_world(precision);
  desc.gravity = {0, 0, -9.81};
  TestWorld test(desc);
  Sheet sheet;
  sheet.rows = sheet.columns = 16;
  sheet.stiffness = 200;
  sheet.vertex_mass = 0.25 / 256;
  weft::ClothDesc cloth_desc;
  const std::vector<weft::Pin> pins{{0, weft::Pin::fixed},
                                    {15, weft::Pin::fixed},
                                    {240, weft::Pin::fixed},
                                    {255, weft::Pin::fixed}};
  cloth_desc.pins = pins;
  cloth_desc.pose.translate = to_weft(place);
  const weft::ClothId cloth = test.add(sheet.grid(), cloth_desc);
  test.step(5e-4, 1000);
  std::vector<Vec> x = test.positions(cloth);
  for (Vec& p : x) p -= place;
  return x;
}

TEST(FarAway, ClothHangsAsAtTheOrigin) {
  const std::vector<Vec> here = hanging_sheet({0, 0, 0}, weft::Precision::float32);
  const std::vector<Vec> exact = hanging_sheet({0, 0, 0}, weft::Precision::float64);
  EXPECT_LT(here[8 * 16 + 8].z, -0.05);
  for (size_t i = 0; i < here.size(); ++i) expect_near(here[i], exact[i], 1e-4);
  for (double far : {1e3, 1e4, 1e5})
    for (Vec place : {Vec{far, 0, 0}, Vec{0, far, far}, Vec{-far, far, -far}}) {
      const std::vector<Vec> there = hanging_sheet(place, weft::Precision::float32);
      for (size_t i = 0; i < here.size(); ++i) expect_near(there[i], here[i], 1e-5);
      if (testing::Test::HasFailure()) FAIL() << "at " << place.x << ' ' << place.y;
    }
}

TEST(FarAway, Float64ClothHangsThereToo) {
  const std::vector<Vec> here = hanging_sheet({0, 0, 0}, weft::Precision::float64);
  const std::vector<Vec> there = hanging_sheet({1e5, -1e5, 1e4}, weft::Precision::float64);
  for (size_t i = 0; i < here.size(); ++i) expect_near(there[i], here[i], 1e-9);
}

using Still = BothPrecisions;

TEST_P(Still, GridWithPowerOfTwoSpacingStaysStill) {
  for (weft::Stencil stencil : {weft::Stencil::seed12, weft::Stencil::classic12,
                                weft::Stencil::quad4, weft::Stencil::tri6}) {
    Sheet sheet;
    sheet.rows = sheet.columns = 33;
    sheet.stencil = stencil;
    TestWorld test(plain_world(GetParam()));
    test.add(sheet.grid(), weft::ClothDesc{});
    const uint64_t before = test.hash();
    test.step(1e-3, 1000);
    EXPECT_EQ(test.hash(), before) << weft::to_string(stencil);
  }
}

TEST_P(Still, MeshAtRestStaysStill) {
  const std::vector<Vec> flat = reference::grid_positions(32, 32);
  reference::SplitMix random(5);
  std::vector<weft::double3> x;
  for (Vec p : flat) x.push_back(to_weft(p + random.noise(0.01)));
  std::vector<uint32_t> indices;
  for (uint32_t r = 0; r < 31; ++r)
    for (uint32_t c = 0; c < 31; ++c) {
      const uint32_t i = r * 32 + c;
      for (uint32_t corner : {i, i + 1, i + 33, i, i + 33, i + 32}) indices.push_back(corner);
    }
  weft::MeshDesc mesh;
  mesh.positions = weft::View<weft::double3>(x);
  mesh.indices = indices;
  mesh.bend = true;
  mesh.material.mass.value = 10;
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = test.add(mesh, weft::ClothDesc{});
  const std::vector<Vec> before = test.positions(cloth);
  test.step(1e-3, 1000);
  const std::vector<Vec> after = test.positions(cloth);
  int moved = 0;
  for (size_t i = 0; i < before.size(); ++i) moved += !same_bits(before[i], after[i]);
  EXPECT_EQ(moved, 0);
}

INSTANTIATE_TEST_SUITE_P(Precision, Still, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
