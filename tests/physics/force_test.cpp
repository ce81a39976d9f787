// Forces, energy and short trajectories of a random 8 x 8 sheet against published numbers, and of
// every stencil against the reference.
#include "reference/sheets.h"

namespace weft_tests::force {
namespace {

constexpr double dt = 6.454972243679e-4;

Sheet random_sheet(weft::Precision precision, weft::Stencil stencil = weft::Stencil::seed12) {
  Sheet sheet;
  sheet.stencil = stencil;
  sheet.noise = 0.01;
  sheet.single = precision == weft::Precision::float32;
  return sheet;
}

/// Largest |difference|/largest |force| of a cloth from those of the reference at its positions.
double force_error(TestWorld& test, weft::ClothId cloth, reference::System system) {
  system.positions = test.positions(cloth);
  const std::vector<Vec> expected = reference::Verlet(system, dt).accelerations();
  const std::vector<Vec> accelerations = test.accelerations(cloth);
  double difference = 0, largest = 0;
  for (size_t i = 0; i < expected.size(); ++i) {
    difference = std::max(difference, length(accelerations[i] - expected[i]));
    largest = std::max(largest, length(expected[i]));
  }
  return difference / largest;
}

using Forces = BothPrecisions;

TEST(ForceTable, GridForcesAreThePublishedOnes) {
  TestWorld test(plain_world(weft::Precision::float64));
  const weft::ClothId cloth = random_sheet(weft::Precision::float64).add_to(test);
  std::vector<Vec> f = test.accelerations(cloth);
  double squares = 0, largest = 0;
  for (Vec& each : f) {
    each = 0.01 * each;
    squares += dot(each, each);
    for (double c : {each.x, each.y, each.z}) largest = std::max(largest, std::abs(c));
  }
  expect_near(f[0], {-15.62740608914, -26.39421633162, 1.213628020275}, 1e-10);
  expect_near(f[27], {48.16711368777, 14.26781493761, -0.9969624306435}, 1e-10);
  expect_near(f[63], {27.90158717146, 23.74008968080, 2.348944939583}, 1e-10);
  EXPECT_NEAR(squares, 1.16139778838572e5, 1e-8);
  EXPECT_NEAR(largest, 71.41854497497, 1e-10);
  EXPECT_NEAR(test.mechanics().elastic, 9.97053246734413, 1e-10);
}

TEST(ForceTable, ValenceSixForcesAreThePublishedOnes) {
  TestWorld test(plain_world(weft::Precision::float64));
  const weft::ClothId cloth =
      random_sheet(weft::Precision::float64, weft::Stencil::tri6).add_to(test);
  double squares = 0;
  for (Vec a : test.accelerations(cloth)) squares += 1e-4 * dot(a, a);
  EXPECT_NEAR(squares, 4.49369190615780e4, 1e-8);
  EXPECT_NEAR(test.mechanics().elastic, 5.78372322951239, 1e-10);
}

TEST_P(Forces, EveryStencilPullsAsTheReference) {
  const double within = GetParam() == weft::Precision::float64 ? 1e-13 : 1e-6;
  for (weft::Stencil stencil : {weft::Stencil::seed12, weft::Stencil::classic12,
                                weft::Stencil::quad4, weft::Stencil::tri6}) {
    Sheet sheet = random_sheet(GetParam(), stencil);
    sheet.rows = 9;
    sheet.columns = 13;
    sheet.noise = 0.1 / 12;
    TestWorld grid(plain_world(GetParam())), network(plain_world(GetParam()));
    const weft::ClothId a = sheet.add_to(grid), b = sheet.add_network_to(network);
    EXPECT_LE(force_error(grid, a, sheet.system()), within) << weft::to_string(stencil);
    EXPECT_LE(force_error(network, b, sheet.system()), within) << weft::to_string(stencil);
    const double energy = reference::elastic_energy(sheet.system().springs, sheet.start());
    EXPECT_NEAR(grid.mechanics().elastic, energy, tolerance(GetParam(), energy));
    EXPECT_NEAR(network.mechanics().elastic, energy, tolerance(GetParam(), energy));
  }
}

TEST_P(Forces, StiffnessClassesPullByThemselves) {
  // Stretch, shear and bend of the two 12-neighbour stencils, one at a time.
  for (weft::Stencil stencil : {weft::Stencil::seed12, weft::Stencil::classic12})
    for (int one = 0; one < 3; ++one) {
      Sheet sheet = random_sheet(GetParam(), stencil);
      if (one == 2) sheet.noise = 0.03;  // 10 % of the length of a bend spring, too
      reference::System system = sheet.system();
      for (reference::Spring& s : system.springs) {
        const int r = std::abs(int(s.b / 8) - int(s.a / 8)),
                  c = std::abs(int(s.b % 8) - int(s.a % 8));
        const int its_class = r + c == 1 ? 0 : (r == 1 && c == 1) ? 1 : 2;
        s.stiffness = its_class == one ? 700 : 0;
      }
      weft::GridDesc grid = sheet.grid();
      grid.material.stiffness = {one == 0 ? 700.0 : 0.0, one == 1 ? 700.0 : 0.0,
                                 one == 2 ? 700.0 : 0.0};
      const std::vector<weft::double3> x = to_weft(sheet.start());
      weft::ClothDesc desc;
      desc.positions = weft::View<weft::double3>(x);
      TestWorld test(plain_world(GetParam()));
      const weft::ClothId cloth = test.add(grid, desc);
      EXPECT_LE(force_error(test, cloth, system),
                GetParam() == weft::Precision::float64 ? 1e-13 : 1e-6)
          << weft::to_string(stencil) << " class " << one;
    }
}

TEST_P(Forces, OnePercentStrainKeepsFiveDigits) {
  Sheet sheet = random_sheet(GetParam());
  sheet.noise = 0.01 / 7;
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = sheet.add_to(test);
  EXPECT_LE(force_error(test, cloth, sheet.system()), 1e-5);
}

TEST_P(Forces, HundredStepsEndAtThePublishedPositions) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -9.81, 0};
  TestWorld test(desc);
  Sheet sheet = random_sheet(GetParam());
  sheet.single = false;
  const weft::ClothId cloth = sheet.add_to(test);
  double before = 0, after = 0;
  for (Vec x : test.positions(cloth)) before += x.y / 64;
  test.step(dt, 100);
  const std::vector<Vec> x = test.positions(cloth);
  for (Vec each : x) after += each.y / 64;
  const Vec a{0.429123410731, 0.400310658248, 0.008393997590};
  const Vec b{-0.002775006477, -0.022767387817, 0.010343096396};
  expect_near(x[27], a, tolerance(GetParam(), length(a)));
  expect_near(x[0], b, tolerance(GetParam(), 1));
  EXPECT_NEAR(before - after, 0.0204375, tolerance(GetParam(), 1));
}

TEST_P(Forces, HundredStepsFollowTheReferenceForEveryStencil) {
  for (weft::Stencil stencil :
       {weft::Stencil::classic12, weft::Stencil::quad4, weft::Stencil::tri6}) {
    Sheet sheet = random_sheet(GetParam(), stencil);
    sheet.pins = {0, 7};
    reference::System system = sheet.system();
    system.gravity = {0, -9.81, 0};
    reference::Verlet verlet(system, dt);
    verlet.steps(100);
    weft::WorldDesc desc = plain_world(GetParam());
    desc.gravity = {0, -9.81, 0};
    TestWorld test(desc);
    const weft::ClothId cloth = sheet.add_to(test);
    test.step(dt, 100);
    const std::vector<Vec> x = test.positions(cloth);
    for (size_t i = 0; i < x.size(); ++i)
      expect_near(x[i], verlet.positions()[i], tolerance(GetParam(), 1));
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, Forces, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::force
