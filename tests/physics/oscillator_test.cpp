// One mass on one spring against the exact solution of the discrete equation (setup A: k = 100,
// m = 1, l0 = 1, x0 = 1.25, at rest).
#include "reference/closed_forms.h"
#include "reference/networks.h"

namespace weft_tests::oscillator {
namespace {

struct Row {
  double dt, taylor, lagged;  // x_1000
};

class SetupA : public testing::TestWithParam<std::tuple<Row, weft::Precision, weft::Form>> {
 protected:
  const Row row = std::get<0>(GetParam());
  const weft::Precision precision = std::get<1>(GetParam());

  double x_1000(weft::Start start) const {
    weft::WorldDesc desc = plain_world(precision, start);
    desc.form = std::get<2>(GetParam());
    TestWorld test(desc);
    const weft::ClothId cloth = AnchoredMass{}.add_to(test);
    test.step(row.dt, 1000);
    const std::vector<Vec> x = test.positions(cloth);
    EXPECT_TRUE(same_bits(x[0], Vec{0, 0, 0}));
    EXPECT_EQ(x[1].y, 0);
    EXPECT_EQ(x[1].z, 0);
    return x[1].x;
  }
};

TEST_P(SetupA, TaylorStartFollowsTheExactSolution) {
  EXPECT_NEAR(x_1000(weft::Start::taylor), row.taylor, tolerance(precision, row.taylor));
}

TEST_P(SetupA, LaggedStartFollowsTheExactSolution) {
  EXPECT_NEAR(x_1000(weft::Start::lagged), row.lagged, tolerance(precision, row.lagged));
}

const auto rows = testing::Values(
    Row{0.001, 0.790237784863305, 0.790917863454}, Row{0.005, 1.241579961740136, 1.243188864832},
    Row{0.01, 1.220671241829135, 1.226553163290}, Row{0.05, 0.773378131542606, 0.746123127431},
    Row{0.1, 0.875, 1.0}, Row{0.19, 1.217061226639643, 1.594426486145});
std::string row_name(const testing::TestParamInfo<SetupA::ParamType>& info) {
  const auto& [row, precision, form] = info.param;
  return "dt" + std::to_string(int(std::lround(1000 * row.dt))) + "ms_" +
         weft::to_string(precision) + (form == weft::Form::summed ? "_summed" : "_position");
}
INSTANTIATE_TEST_SUITE_P(Summed, SetupA,
                         testing::Combine(rows, both_precisions(),
                                          testing::Values(weft::Form::summed)),
                         row_name);
// In float32 the papers' form has no useful tolerance.
INSTANTIATE_TEST_SUITE_P(Position, SetupA,
                         testing::Combine(rows, testing::Values(weft::Precision::float64),
                                          testing::Values(weft::Form::position)),
                         row_name);

using Oscillator = BothPrecisions;

TEST_P(Oscillator, InitialVelocityEntersExactly) {
  const double dt = 0.01;
  AnchoredMass mass;
  mass.velocity = {0.7, 0, 0};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  for (int n = 0; n <= 300; n += 50) {
    const double expected = 1 + reference::oscillator(0.25, 0.7, 10, dt, n);
    EXPECT_NEAR(test.position(cloth, 1).x, expected, tolerance(GetParam(), expected)) << n;
    test.step(dt, 50);
  }
}

TEST_P(Oscillator, VelocityIsTheCentralDifference) {
  const double dt = 0.01;
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = AnchoredMass{}.add_to(test);
  test.step(dt, 70);
  const double after = reference::oscillator(0.25, 0, 10, dt, 71);
  const double before = reference::oscillator(0.25, 0, 10, dt, 69);
  const double expected = (after - before) / (2 * dt);
  EXPECT_NEAR(test.velocities(cloth)[1].x, expected,
              GetParam() == weft::Precision::float64 ? 1e-10 : 2e-5 * 2.5);
  EXPECT_TRUE(same_bits(test.velocities(cloth)[0], Vec{0, 0, 0}));
}

TEST_P(Oscillator, VelocityBeforeTheFirstStepIsTheGivenOne) {
  AnchoredMass mass;
  mass.velocity = {0.75, -0.5, 0.25};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  expect_near(test.velocities(cloth)[1], {0.75, -0.5, 0.25}, tolerance(GetParam(), 1));
}

TEST_P(Oscillator, SubstepsAreSteps) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.substeps = 100;
  TestWorld test(desc);
  const weft::ClothId cloth = AnchoredMass{}.add_to(test);
  test.step(1.0, 10);
  EXPECT_NEAR(test.position(cloth, 1).x, 1.220671241829135, tolerance(GetParam(), 1.22));
  EXPECT_NEAR(test.world().time(), 10.0, 1e-12);
  EXPECT_EQ(test.world().stats().steps, 1000u);
  EXPECT_EQ(test.world().stats().frames, 10u);
  EXPECT_EQ(test.world().stats().substeps_last, 100u);
}

TEST(OscillatorInvariant, HasNoDriftInFloat64) {
  const double dt = 0.05;
  TestWorld test(plain_world(weft::Precision::float64));
  const weft::ClothId cloth = AnchoredMass{}.add_to(test);
  double before = 0.25;
  for (int n = 0; n < 20000; ++n) {
    test.step(dt);
    const double u = test.position(cloth, 1).x - 1, v = (u - before) / dt;
    ASSERT_NEAR(v * v + 100 * u * before, 5.859375, 1e-10) << n;
    before = u;
  }
}

TEST(OscillatorInvariant, MillionFloat32StepsKeepThePhase) {
  // dt^2 = 2^-14 is exact in float32. A dt^2 that is rounded, 2.5e-8 off at dt = 0.01, turns the
  // phase by 1.25e-3 in a million steps whatever the arithmetic of a step is.
  const double dt = 1.0 / 128;
  weft::WorldDesc desc = plain_world(weft::Precision::float32);
  desc.substeps = 1000;
  TestWorld test(desc);
  const weft::ClothId cloth = AnchoredMass{}.add_to(test);
  test.step(1000 * dt, 1000);
  EXPECT_NEAR(test.position(cloth, 1).x, 1 + reference::oscillator(0.25, 0, 10, dt, 1000000), 5e-5);
}

TEST(OscillatorInvariant, MillionFloat32StepsKeepTheAmplitude) {
  weft::WorldDesc desc = plain_world(weft::Precision::float32);
  desc.substeps = 1000;
  TestWorld test(desc);
  const weft::ClothId cloth = AnchoredMass{}.add_to(test);
  test.step(10.0, 999);
  double amplitude = 0;
  const double theta = reference::verlet_angle(0.1);
  for (int n = 0; n < 5; ++n) {
    test.step(10.0);
    const double u = test.position(cloth, 1).x - 1;
    const double v = test.velocities(cloth)[1].x;
    // u = U cos n theta and v = -U sin theta/dt sin n theta
    amplitude = std::max(amplitude, std::hypot(u, v * 0.01 / std::sin(theta)));
  }
  EXPECT_NEAR(amplitude, 0.25, 5e-5);
}

INSTANTIATE_TEST_SUITE_P(Precision, Oscillator, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::oscillator
