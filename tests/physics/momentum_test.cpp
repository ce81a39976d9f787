// Momentum of free motion (HC63) and the energy of a regular one.
#include "reference/networks.h"
#include "reference/sheets.h"

namespace weft_tests {
namespace {

using Momentum = BothPrecisions;

Sheet flying_sheet() {
  Sheet sheet;
  sheet.rows = sheet.columns = 32;
  sheet.noise = 0.1 / 31;
  return sheet;
}

void expect_momentum(const weft::Mechanics& now, Vec expected, double relative) {
  expect_near(from_weft(now.momentum), expected, relative * length(expected));
}

TEST_P(Momentum, IsConstantWithoutGravity) {
  const double within = GetParam() == weft::Precision::float64 ? 1e-12 : 1e-7;
  weft::ClothDesc desc;
  desc.velocity = {1, 0.5, -0.25};
  TestWorld test(plain_world(GetParam()));
  const Sheet sheet = flying_sheet();
  sheet.add_to(test, desc);
  const double mass = sheet.vertex_mass * sheet.count();
  const Vec expected{mass, 0.5 * mass, -0.25 * mass};
  for (int n = 0; n < 2000; n += 400) {
    test.step(5e-4, 400);
    expect_momentum(test.mechanics(), expected, within);
  }
}

TEST_P(Momentum, IsUniformAfterGravityIsSwitchedOff) {
  const double dt = 5e-4, g = 9.81;
  weft::WorldDesc world = plain_world(GetParam());
  world.gravity = {0, -g, 0};
  TestWorld test(world);
  const Sheet sheet = flying_sheet();
  const weft::ClothId cloth = sheet.add_to(test);
  const auto centre = [&] {
    Vec sum;
    for (Vec x : test.positions(cloth)) sum += (1.0 / sheet.count()) * x;
    return sum;
  };
  const Vec start = centre();
  test.step(dt, 400);
  const double t = 400 * dt, fallen = g * t * t / 2;
  EXPECT_NEAR(centre().y, start.y - fallen, tolerance(GetParam(), 1));
  test.check(test.world().set_gravity({0, 0, 0}));
  const Vec middle = centre();
  // Its displacement per step stays that of the last step.
  const double d = g * dt * dt * 399.5;
  test.step(dt, 400);
  EXPECT_NEAR(centre().y, middle.y - 400 * d, tolerance(GetParam(), 1));
  EXPECT_NEAR(centre().x, start.x, tolerance(GetParam(), 1));
  const double mass = sheet.vertex_mass * sheet.count();
  const weft::Mechanics now = test.mechanics();
  EXPECT_NEAR(now.momentum.y, -mass * d / dt,
              GetParam() == weft::Precision::float64 ? 1e-10 : 2e-5 * mass * d / dt);
  test.step(dt, 400);
  expect_momentum(test.mechanics(), from_weft(now.momentum),
                  GetParam() == weft::Precision::float64 ? 1e-12 : 1e-7);
}

TEST(AngularMomentum, IsConstantInFloat64) {
  const Sheet sheet = flying_sheet();
  TestWorld test(plain_world(weft::Precision::float64));
  std::vector<weft::double3> v;
  for (Vec x : sheet.start()) v.push_back({-(x.y - 0.5), x.x - 0.5, 0.1 * x.x});
  weft::ClothDesc desc;
  desc.velocities = v;
  const weft::ClothId cloth = sheet.add_to(test, desc);
  std::vector<Vec> before = test.positions(cloth);
  double first = 0;
  for (int n = 0; n < 500; ++n) {
    test.step(5e-4);
    const std::vector<Vec> x = test.positions(cloth);
    double l = 0;  // z of the sum of x_(n-1) x x_n
    for (size_t i = 0; i < x.size(); ++i) l += before[i].x * x[i].y - before[i].y * x[i].x;
    if (n == 0) first = l;
    ASSERT_NEAR(l, first, 1e-10 * std::abs(first)) << n;
    before = x;
  }
}

using Energy = BothPrecisions;

struct Pendulum {
  AnchoredMass mass;
  weft::WorldDesc world;
  explicit Pendulum(weft::Precision precision) : world(plain_world(precision)) {
    world.gravity = {0, -9.81, 0};
    mass.start = {1.2, 0, 0.1};
    mass.velocity = {0, 0.5, 0.3};
  }
};

TEST_P(Energy, OfTheElasticPendulumStaysBounded) {
  struct Bound {
    double dt, error;
  };
  double previous = 0;
  for (const Bound bound : {Bound{0.04, 0.16970}, Bound{0.02, 0.042814}, Bound{0.01, 0.010729},
                            Bound{0.005, 0.0026836}}) {
    const Pendulum pendulum(GetParam());
    TestWorld test(pendulum.world);
    pendulum.mass.add_to(test);
    const auto total = [&] {
      const weft::Mechanics m = test.mechanics();
      return m.kinetic + m.elastic + m.potential;
    };
    EXPECT_NEAR(total(), 2.254054212, tolerance(GetParam(), 2.25) + 1e-9);
    double error = 0, early = 0;
    const int steps = 20000;
    for (int n = 0; n < steps; ++n) {
      test.step(bound.dt);
      error = std::max(error, std::abs(total() - 2.254054212));
      if (n == steps / 10) early = error;
    }
    EXPECT_LE(error, 1.2 * bound.error) << bound.dt;
    EXPECT_GE(error, 0.7 * bound.error) << bound.dt;
    EXPECT_LE(error, 1.2 * early) << bound.dt;
    if (previous > 0) {
      EXPECT_NEAR(std::log2(previous / error), 2, 0.1) << bound.dt;
    }
    previous = error;
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, Momentum, both_precisions(), precision_name);
INSTANTIATE_TEST_SUITE_P(Precision, Energy, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
