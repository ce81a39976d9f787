// Wedges narrower than the cloth, pins inside colliders, and momentum without any (HC52, HC53,
// HC63).
#include "reference/effects.h"
#include "reference/sheets.h"

namespace weft_tests::collider_stability {
namespace {

using ColliderStability = BothPrecisions;

constexpr double dt = 1.0 / 60;

struct Extremes {
  double energy = -1e300, lowest = 1e300, highest = -1e300, widest = 0;
};
/// Steps a damped sheet and looks at it after each.
Extremes watch(TestWorld& test, weft::ClothId cloth, int steps) {
  Extremes seen;
  for (int n = 0; n < steps; ++n) {
    test.step(0.004);
    const weft::Mechanics m = test.mechanics();
    seen.energy = std::max(seen.energy, m.kinetic + m.elastic + m.potential);
    for (const Vec x : test.positions(cloth)) {
      seen.lowest = std::min(seen.lowest, x.y);
      seen.highest = std::max(seen.highest, x.y);
      seen.widest = std::max({seen.widest, std::abs(x.x), std::abs(x.z)});
    }
  }
  return seen;
}

/// A square sheet of side 1 about the origin, level, at height y.
weft::ClothId add_level_sheet(TestWorld& test, double y, double drag = 1e-4, uint32_t n = 16) {
  Sheet sheet;
  sheet.rows = sheet.columns = n;
  sheet.stiffness = 40;
  sheet.vertex_mass = 0.25 / (n * n);
  weft::ClothDesc desc;
  desc.pose = {{1, 0, 0}, 90, {-0.5, y, -0.5}};
  desc.drag = drag;
  desc.spring_damping = 0.002;
  return test.add(sheet.grid(), desc);
}

weft::WorldDesc automatic(weft::Precision precision) {
  weft::WorldDesc desc;
  desc.precision = precision;
  return desc;
}

template <class Create>
void expect_no_gain_in_wedge(weft::Precision precision, Create create) {
  TestWorld test(automatic(precision));
  const weft::ClothId cloth = add_level_sheet(test, 0.6);
  create(test);
  const weft::Mechanics start = test.mechanics();
  const double energy = start.kinetic + start.elastic + start.potential;
  const Extremes seen = watch(test, cloth, 2000);
  EXPECT_LE(seen.energy, energy + 1e-3 * std::abs(energy));
  EXPECT_LE(seen.highest, 0.7);
  EXPECT_LE(seen.widest, 2);
  EXPECT_GE(seen.lowest, -1.5);
  const weft::Mechanics end = test.mechanics();
  EXPECT_LE(end.kinetic, 0.01 * std::abs(energy));
}

TEST_P(ColliderStability, ASheetInAWedgeOfTwoPlanesGainsNoEnergy) {
  for (const double friction : {0.0, 0.5}) {
    expect_no_gain_in_wedge(GetParam(), [&](TestWorld& test) {
      for (const double side : {-1.0, 1.0}) {
        weft::PlaneDesc wall;
        wall.normal = {side, 0.4, 0};
        wall.offset = -0.3;
        wall.friction = friction;
        test.take(test.world().create_plane(wall));
      }
      weft::PlaneDesc ends;  // so that it cannot leave along the edge
      for (const double side : {-1.0, 1.0}) {
        ends.normal = {0, 0, side};
        ends.offset = -0.6;
        test.take(test.world().create_plane(ends));
      }
    });
  }
}

TEST_P(ColliderStability, ASheetBetweenTwoSpheresGainsNoEnergy) {
  expect_no_gain_in_wedge(GetParam(), [](TestWorld& test) {
    for (const double side : {-1.0, 1.0}) {
      weft::SphereDesc sphere;
      sphere.center = {side * 0.505, 0, 0};
      sphere.radius = 0.5;
      sphere.friction = 0.4;
      test.take(test.world().create_sphere(sphere));
    }
    weft::PlaneDesc floor;
    floor.offset = -0.9;
    floor.friction = 0.5;
    test.take(test.world().create_plane(floor));
  });
}

TEST_P(ColliderStability, AParticleBetweenWallsThatOverlapIsNotDrivenFaster) {
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = add_particles(test, {{0, 0.004, 0}}, {0, 0.05, 0});
  for (const double side : {-1.0, 1.0}) {  // one wants y >= 0.01, the other y <= 0
    weft::PlaneDesc wall;
    wall.normal = {0, side, 0};
    wall.offset = side > 0 ? 0.01 : 0;
    test.take(test.world().create_plane(wall));
  }
  double first = 0, second = 0;
  for (int n = 0; n < 2000; ++n) {
    test.step(dt);
    EXPECT_LE(std::abs(test.position(cloth, 0).y), 0.02);
    double& most = n < 1000 ? first : second;
    most = std::max(most, test.mechanics().kinetic);
  }
  EXPECT_LE(second, first * 1.0001);
}

TEST_P(ColliderStability, PinsInsideEveryShapeKeepTheirBits) {
  const Vec top{0.25, 0.5, -0.125}, inside = top - Vec{0, 0.05, 0};
  for (const weft::Form form : {weft::Form::summed, weft::Form::position})
    for (const Body body : every_body) {
      SCOPED_TRACE(name(body));
      weft::WorldDesc desc = automatic(GetParam());
      desc.form = form;
      TestWorld with(desc), without(desc);
      std::vector<weft::ClothId> ids;
      for (TestWorld* test : {&with, &without}) {
        const std::vector<weft::double3> x{to_weft(inside), to_weft(inside - Vec{0, 0.02, 0}),
                                           to_weft(top + Vec{0, 1, 0})};
        const std::vector<weft::Spring> springs{{0, 2, 1, 2}, {1, 2, 1, 2}};
        const std::vector<weft::Pin> pins{{0, weft::Pin::fixed}, {1, 0}};
        const std::vector<weft::PinMotion> motions{{{0.1, 0, 0}, {0, 0.03, 0}, 9}};
        weft::NetworkDesc network;
        network.positions = weft::View<weft::double3>(x);
        network.springs = springs;
        weft::ClothDesc cloth;
        cloth.pins = pins;
        cloth.motions = motions;
        ids.push_back(test->add(network, cloth));
      }
      add_body(with, body, top, 0.1, 0.5, {0.2, 0.1, 0});
      for (int n = 0; n < 60; ++n) {
        with.step(dt);
        without.step(dt);
        for (const uint32_t pin : {0u, 1u})
          ASSERT_TRUE(same_bits(with.position(ids[0], pin), without.position(ids[1], pin))) << pin;
      }
    }
}

TEST_P(ColliderStability, AfterGravityIsSwitchedOffMomentumIsConstant) {
  TestWorld test(automatic(GetParam()));
  Sheet sheet;
  sheet.noise = 0.005;
  sheet.stiffness = 100;
  weft::ClothDesc desc;
  desc.velocity = {1, 0.5, -2};
  const weft::ClothId cloth = sheet.add_to(test, desc);
  test.step(dt, 20);
  test.check(test.world().set_gravity({0, 0, 0}));
  test.step(dt);
  const auto centre = [&] {
    Vec sum;
    for (const Vec x : test.positions(cloth)) sum += x;
    return (1.0 / sheet.count()) * sum;
  };
  const Vec momentum = from_weft(test.mechanics().momentum), start = centre();
  // The last velocity under gravity was that of half a substep before the switch.
  const double fallen = 20 * dt - test.world().stats().dt_last / 2;
  EXPECT_NEAR(momentum.y / (0.01 * sheet.count()), 0.5 - 9.81 * fallen, 1e-5);
  for (int n = 1; n <= 200; ++n) {
    test.step(dt);
    const Vec now = from_weft(test.mechanics().momentum);
    // What rounding leaves: in float32 the last digits walk.
    const double rounding = GetParam() == weft::Precision::float32 ? 2e-7 : 1e-12;
    ASSERT_LE(length(now - momentum), rounding * length(momentum)) << n;
    const Vec expected = start + (n * dt / (0.01 * sheet.count())) * momentum;
    ASSERT_LE(length(centre() - expected), tolerance(GetParam(), length(expected))) << n;
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, ColliderStability, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::collider_stability
