// Prescribed motion of pins, moving them by hand, letting them go (HC56 to HC59).
#include "reference/closed_forms.h"
#include "reference/networks.h"

namespace weft_tests {
namespace {

using PinMotion = BothPrecisions;

// Longer than the swing of 5 m that a pin at 50 m/s causes: the spring never turns round.
constexpr double long_spring = 20;

TEST_P(PinMotion, PinAtConstantVelocityDragsTheMass) {
  const double dt = 0.01, speed = 50;
  AnchoredMass mass;
  mass.rest_length = long_spring;
  mass.start = {long_spring, 0, 0};
  mass.motions = {{{speed, 0, 0}, {0, 0, 0}, 0}};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  test.step(dt, 1000);
  const std::vector<Vec> x = test.positions(cloth);
  const double expected = 503.352768584427 - 1 + long_spring;
  EXPECT_NEAR(x[1].x, expected, tolerance(GetParam(), expected));
  EXPECT_NEAR(x[0].x, 500, tolerance(GetParam(), 500));
  EXPECT_NEAR(test.velocities(cloth)[0].x, speed, tolerance(GetParam(), speed));
}

TEST_P(PinMotion, SpringWithoutRestLengthIsDraggedToo) {
  AnchoredMass mass;
  mass.rest_length = 0;
  mass.start = {0, 0, 0};
  mass.motions = {{{50, 0, 0}, {0, 0, 0}, 0}};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  test.step(0.01, 1000);
  EXPECT_NEAR(test.position(cloth, 1).x, 502.352768584427, tolerance(GetParam(), 502));
}

TEST_P(PinMotion, SinusoidalPinDrivesTheMass) {
  const double dt = 0.01;
  AnchoredMass mass;
  mass.start = {1, 0, 0};
  mass.motions = {{{0, 0, 0}, {0.3, 0, 0}, 7}};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  for (int n = 50; n <= 1000; n += 50) {
    test.step(dt, 50);
    const double expected = reference::driven_by_pin(1, 0.3, 7, 10, dt, n);
    EXPECT_NEAR(test.position(cloth, 1).x, expected, tolerance(GetParam(), 1.6)) << n;
    EXPECT_NEAR(test.position(cloth, 0).x, 0.3 * std::sin(7 * n * dt), tolerance(GetParam(), 0.3));
  }
  EXPECT_NEAR(test.position(cloth, 1).x, 1.648574621650, tolerance(GetParam(), 1.648574621650));
}

TEST_P(PinMotion, PinsFollowTheirMotionAtEverySubstep) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.substeps = 50;
  TestWorld test(desc);
  AnchoredMass mass;
  mass.start = {1, 0, 0};
  mass.motions = {{{0, 0, 0}, {0.3, 0, 0}, 7}};
  const weft::ClothId cloth = mass.add_to(test);
  test.step(0.5, 20);
  EXPECT_NEAR(test.position(cloth, 1).x, 1.648574621650, tolerance(GetParam(), 1.648574621650));
}

TEST_P(PinMotion, ReleasedPinKeepsItsLastDisplacement) {
  const double dt = 0.01, speed = 3, amplitude = 0.3, omega = 7;
  const auto pin = [&](int n) { return speed * n * dt + amplitude * std::sin(omega * n * dt); };
  AnchoredMass mass;
  mass.stiffness = 0;
  mass.motions = {{{speed, 0, 0}, {amplitude, 0, 0}, omega}};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  test.step(dt, 40);
  const std::vector<uint32_t> anchor{0};
  test.check(test.world().release_pins(cloth, anchor));
  const double d = pin(40) - pin(39);
  for (int n = 1; n <= 20; ++n) {
    test.step(dt);
    const double expected = pin(40) + n * d;
    ASSERT_NEAR(test.position(cloth, 0).x, expected, tolerance(GetParam(), expected)) << n;
  }
}

TEST_P(PinMotion, ReleasedFixedPinFallsFromRest) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -9.81, 0};
  TestWorld test(desc);
  AnchoredMass mass;
  mass.stiffness = 0;
  const weft::ClothId cloth = mass.add_to(test);
  test.step(0.01, 10);
  EXPECT_TRUE(same_bits(test.position(cloth, 0), Vec{0, 0, 0}));
  const std::vector<uint32_t> anchor{0};
  test.check(test.world().release_pins(cloth, anchor));
  test.step(0.01, 50);
  // Its displacement was 0: the drop of a lagged start.
  const double drop = 9.81 * 0.5 * 0.51 / 2;
  EXPECT_NEAR(test.position(cloth, 0).y, -drop, tolerance(GetParam(), drop));
}

TEST_P(PinMotion, MovedPinRunsLinearlyOverOneStep) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.substeps = 4;
  TestWorld test(desc);
  AnchoredMass mass;
  mass.stiffness = 0;
  const weft::ClothId cloth = mass.add_to(test);
  const std::vector<uint32_t> anchor{0};
  const std::vector<weft::double3> target{{2, -1, 0.5}};
  test.check(test.world().move_pins(cloth, anchor, weft::View<weft::double3>(target)));
  EXPECT_TRUE(same_bits(test.position(cloth, 0), Vec{0, 0, 0}));
  test.step(0.04);
  expect_near(test.position(cloth, 0), {2, -1, 0.5}, tolerance(GetParam(), 2));
  expect_near(test.velocities(cloth)[0], {50, -25, 12.5},
              GetParam() == weft::Precision::float64 ? 1e-8 : 50 * 2e-5);
  test.step(0.04, 3);
  expect_near(test.position(cloth, 0), {2, -1, 0.5}, tolerance(GetParam(), 2));
}

TEST_P(PinMotion, MovingAFreeVertexPinsIt) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -9.81, 0};
  TestWorld test(desc);
  const weft::ClothId cloth = add_particles(test, {{0, 0, 0}, {1, 0, 0}});
  const std::vector<uint32_t> vertex{1};
  const std::vector<weft::double3> target{{1, 3, 0}};
  test.check(test.world().move_pins(cloth, vertex, weft::View<weft::double3>(target)));
  test.step(0.01, 100);
  expect_near(test.position(cloth, 1), {1, 3, 0}, tolerance(GetParam(), 3));
  EXPECT_NEAR(test.position(cloth, 0).y, -4.905, tolerance(GetParam(), 4.905));
}

TEST_P(PinMotion, TeleportedPinAtMostDoublesTheJump) {
  const double dt = 0.01, jump = 10, theta = reference::verlet_angle(10 * dt);
  AnchoredMass mass;
  mass.rest_length = 0;
  mass.start = {0, 0, 0};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = mass.add_to(test);
  const std::vector<uint32_t> anchor{0};
  const std::vector<weft::double3> target{{jump, 0, 0}};
  test.check(test.world().move_pins(cloth, anchor, weft::View<weft::double3>(target)));
  for (int n = 1; n <= 500; ++n) {
    test.step(dt);
    const double expected = jump - jump * std::cos((n - 0.5) * theta) / std::cos(theta / 2);
    ASSERT_NEAR(test.position(cloth, 1).x, expected, tolerance(GetParam(), 2 * jump)) << n;
  }
}

TEST_P(PinMotion, VelocityOfALedPinIsThatOfThePresent) {
  AnchoredMass mass;
  mass.motions = {{{0.5, -1, 2}, {0.3, 0.2, -0.4}, 9}};
  for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
    weft::WorldDesc desc = plain_world(GetParam());
    desc.form = form;
    desc.substeps = 3;
    TestWorld test(desc);
    const weft::ClothId cloth = mass.add_to(test);
    for (int n = 0; n < 12; ++n) {
      const double t = test.world().time(), c = 9 * std::cos(9 * t);
      expect_near(test.velocities(cloth)[0], Vec{0.5, -1, 2} + c * Vec{0.3, 0.2, -0.4}, 1e-6);
      test.step(n % 3 == 0 ? 0.05 : 0.02);
    }
  }
}

TEST_P(PinMotion, VelocityOfAMovedPinIsThatOfItsLastSubstepAndThenZero) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.substeps = 2;
  TestWorld test(desc);
  AnchoredMass mass;
  mass.stiffness = 0;
  const weft::ClothId cloth = mass.add_to(test);
  const std::vector<uint32_t> anchor{0};
  const double within = GetParam() == weft::Precision::float64 ? 1e-8 : 1e-3;
  for (const double dt : {0.04, 0.01}) {
    const Vec from = test.position(cloth, 0), to = from + Vec{1, 2, -1};
    const std::vector<weft::double3> target{to_weft(to)};
    test.check(test.world().move_pins(cloth, anchor, weft::View<weft::double3>(target)));
    test.step(dt);
    expect_near(test.velocities(cloth)[0], (1 / dt) * (to - from), within / dt);
    test.step(dt);
    expect_near(test.velocities(cloth)[0], {0, 0, 0}, within);
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, PinMotion, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
