// Circular orbits and rotating rings: exact solutions of the discrete equation in the plane, at
// large rotations.
#include "reference/networks.h"

#include <numbers>

namespace weft_tests {
namespace {

using Rotation = BothPrecisions;

TEST_P(Rotation, CircularOrbitIsExact) {
  const double k = 100, l0 = 1, r = 1.5;
  struct Orbit {
    double dt, theta;
  };
  for (const Orbit orbit : {Orbit{0.01, 0.057743048681226}, Orbit{0.05, 0.289686993997119},
                            Orbit{0.1, 0.585685543457151}}) {
    // The published angles agree with 4 sin^2(theta/2) = dt^2 k/m (1 - l0/r).
    ASSERT_NEAR(2 * std::asin(0.5 * orbit.dt * std::sqrt(k * (1 - l0 / r))), orbit.theta, 1e-14);
    AnchoredMass mass;
    mass.start = {r, 0, 0};
    mass.velocity = {0, r * std::sin(orbit.theta) / orbit.dt, 0};
    TestWorld test(plain_world(GetParam()));
    const weft::ClothId cloth = mass.add_to(test);
    // An orbit amplifies rounding: in float64, too, 5,000 units in the last place after 1,000
    // steps.
    const int steps = GetParam() == weft::Precision::float64 ? 20000 : 100;
    for (int n = 0; n <= steps; n += 50) {
      const Vec expected{r * std::cos(n * orbit.theta), r * std::sin(n * orbit.theta), 0};
      expect_near(test.position(cloth, 1), expected, tolerance(GetParam(), r));
      if (HasFailure()) FAIL() << "dt " << orbit.dt << ", step " << n;
      test.step(orbit.dt, 50);
    }
  }
}

TEST_P(Rotation, RingOfTwelveIsExact) {
  const int sides = 12;
  const double l0 = 0.5, k = 200, m = 0.3, r = 1.2, dt = 0.01, pi = std::numbers::pi;
  const double l = 2 * r * std::sin(pi / sides);
  const double theta =
      2 * std::asin(0.5 * dt * std::sqrt(2 * k * (l - l0) * std::sin(pi / sides) / (m * r)));
  ASSERT_NEAR(theta, 0.059037749835794, 1e-14);
  const auto corner = [&](int i, int n) {
    const double a = 2 * pi * i / sides + n * theta;
    return Vec{r * std::cos(a), r * std::sin(a), 0};
  };
  NetworkParts ring;
  ring.masses = {m};
  for (int i = 0; i < sides; ++i) {
    const Vec p = corner(i, 0);
    ring.positions.push_back(p);
    ring.velocities.push_back((std::sin(theta) / dt) * Vec{-p.y, p.x, 0});
    ring.springs.push_back({uint32_t(i), uint32_t((i + 1) % sides), k, l0});
  }
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = add_network(test, ring);
  const int steps = GetParam() == weft::Precision::float64 ? 2000 : 300;
  test.step(dt, steps);
  const std::vector<Vec> x = test.positions(cloth);
  for (int i = 0; i < sides; ++i)
    expect_near(x[size_t(i)], corner(i, steps), tolerance(GetParam(), r));
}

INSTANTIATE_TEST_SUITE_P(Precision, Rotation, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
