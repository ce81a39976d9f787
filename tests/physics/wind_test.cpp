// Wind against closed forms (HC07, HC60, HC61) and as no effect at all.
#include "reference/effects.h"

namespace weft_tests {
namespace {

using Wind = BothPrecisions;

constexpr double dt = 1.0 / 60;

/// A triangle of 1 m^2 in the plane of `across` and `beside`, 1e-3 kg at each vertex.
Triangles triangle() {
  Triangles mesh;
  mesh.vertices = {{0, 0, 0}, across, 2 * beside};
  mesh.faces = {{0, 1, 2}};
  return mesh;
}
weft::ClothId add_triangle(TestWorld& test, Vec velocity = {}) {
  weft::ClothDesc cloth;
  cloth.velocity = to_weft(velocity);
  return add_mesh_cloth(test, triangle(), slack(weft::Mass::Kind::total, 3e-3), cloth);
}
/// With this air the drag b of hard case 60 is 1e-3 kg/m for each vertex.
weft::WindDesc thin_air(Vec velocity, double normal, double tangential) {
  return {to_weft(velocity), 6e-3, normal, tangential};
}

TEST_P(Wind, AStormFollowsTheLimitedStepToItsFifthVelocity) {
  for (const double tangential : {0.0, 1.0})
    for (const double side : {-1.0, 1.0}) {
      TestWorld test(plain_world(GetParam(), weft::Start::lagged));
      const weft::ClothId cloth = add_triangle(test);
      test.check(test.world().set_wind(thin_air(side * 1000 * ahead, 1, tangential)));
      double w = 1000, moved = 0;
      for (int n = 1; n <= 5; ++n) {
        const std::vector<Vec> before = test.positions(cloth);
        test.step(dt);
        w = w / (1 + w * dt);
        moved = side * (1000 - w) * dt;
        const std::vector<Vec> x = test.positions(cloth);
        for (size_t i = 0; i < 3; ++i)
          expect_near(x[i] - before[i], moved * ahead,
                      (GetParam() == weft::Precision::float64 ? 1e-9 : 1e-5) * 1000 * dt);
      }
      EXPECT_NEAR(std::abs(moved) / dt, 988.1423, 1e-4 * 988.1423);
    }
}

TEST_P(Wind, NoStepReversesTheRelativeVelocity) {
  for (double speed = 1; speed <= 1e5; speed *= 10)
    for (const Vec direction :
         {ahead, across, 0.6 * ahead + 0.8 * beside, 0.96 * across - 0.28 * ahead}) {
      TestWorld test(plain_world(GetParam(), weft::Start::lagged));
      const Vec wind = speed * direction;
      const weft::ClothId cloth = add_triangle(test);
      test.check(test.world().set_wind(thin_air(wind, 1, 0.7)));
      Vec u = wind;
      for (int n = 0; n < 30; ++n) {
        const Vec before = test.position(cloth, 0);
        test.step(dt);
        const Vec now = wind - (1 / dt) * (test.position(cloth, 0) - before);
        const double rounding = 1e-5 * speed;
        EXPECT_GE(dot(now, ahead) * dot(u, ahead), -rounding * rounding);
        EXPECT_GE(dot(now, u), -rounding * rounding) << speed;
        EXPECT_LE(length(now), length(u) + rounding) << speed;
        u = now;
      }
    }
}

weft::GridDesc flat_grid(uint32_t rows, uint32_t columns, double density) {
  weft::GridDesc grid;
  grid.rows = rows;
  grid.columns = columns;
  grid.material = slack(weft::Mass::Kind::density, density);
  return grid;
}

TEST_P(Wind, InThePlaneOfASheetWithoutTangentialDragThereIsNoForce) {
  for (const double degrees : {0.0, 37.0}) {
    TestWorld test(plain_world(GetParam()));
    weft::ClothDesc desc;
    desc.pose = {{1, 2, 3}, degrees, {}};
    const weft::ClothId cloth = test.add(flat_grid(5, 7, 0.2), desc);
    const Vec wind = turned({8, -3, 0}, {1, 2, 3}, degrees);
    test.check(test.world().set_wind({to_weft(wind), 1.225, 1, 0}));
    test.check(test.world().prepare(1e-6));
    for (const Vec a : test.accelerations(cloth)) EXPECT_LE(length(a), 1e-5);
    test.check(test.world().set_wind({to_weft(wind), 1.225, 1, 0.02}));
    EXPECT_GT(length(test.accelerations(cloth)[8]), 1);
  }
}

TEST_P(Wind, AsFastAsTheSheetChangesNoBit) {
  const Vec velocity{3, 1, -2};
  weft::ClothDesc desc;
  desc.velocity = to_weft(velocity);
  TestWorld with(plain_world(GetParam())), without(plain_world(GetParam()));
  with.add(flat_grid(5, 7, 0.2), desc);
  without.add(flat_grid(5, 7, 0.2), desc);
  with.check(with.world().set_wind({desc.velocity}));
  for (int n = 0; n < 50; ++n) {
    with.step(dt);
    without.step(dt);
    ASSERT_EQ(with.hash(), without.hash()) << n;
  }
}

TEST_P(Wind, AFallingTriangleInStillAirReachesItsTerminalSpeedAtAnyStep) {
  const double air = 1.225, g = 9.81;
  for (const double density : {0.2, 0.02})
    for (const double step : {1.0 / 20, dt, 1.0 / 300}) {
      weft::WorldDesc world = plain_world(GetParam(), weft::Start::lagged);
      world.gravity = to_weft(-g * ahead);
      TestWorld test(world);
      const weft::ClothId cloth =
          add_mesh_cloth(test, triangle(), slack(weft::Mass::Kind::density, density));
      test.check(test.world().set_wind({{0, 0, 0}, air, 1, 0}));
      test.step(step, int(4 / step));
      const std::vector<Vec> before = test.positions(cloth);
      test.step(step);
      const double terminal = std::sqrt(2 * density * g / air);
      const std::vector<Vec> x = test.positions(cloth);
      for (size_t i = 0; i < x.size(); ++i)
        expect_near((1 / step) * (x[i] - before[i]), -terminal * ahead,
                    GetParam() == weft::Precision::float64 ? 1e-9 : 2e-6 / step);
    }
}

TEST_P(Wind, ASheetThatFallsFlatIsBrakedAlikeEverywhere) {
  const double density = 0.2, air = 1.225, g = 9.81;
  weft::WorldDesc world = plain_world(GetParam(), weft::Start::lagged);
  world.gravity = {0, 0, -g};
  TestWorld test(world);
  const weft::ClothId cloth = test.add(flat_grid(4, 6, density), weft::ClothDesc{});
  test.check(test.world().set_wind({{0, 0, 0}, air, 1, 0}));
  double v = 0, z = 0;
  for (int n = 0; n < 20; ++n) {
    const double b = air / (2 * density);
    v += dt * (g - b * v * v) / (1 + b * v * dt);
    z -= v * dt;
    test.step(dt);
    for (const Vec x : test.positions(cloth)) ASSERT_NEAR(x.z, z, tolerance(GetParam(), 1));
  }
}

TEST_P(Wind, DegenerateTrianglesFeelNothing) {
  Triangles mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1e-6, 0}, {5, 5, 5}};
  mesh.faces = {{0, 1, 2}, {1, 2, 3}, {0, 1, 4}, {0, 1, 5}};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = add_mesh_cloth(test, mesh, slack(weft::Mass::Kind::total, 0.7));
  test.check(test.world().set_wind({{3, 4, 5}, 1.225, 1, 0.5}));
  test.check(test.world().prepare(1e-6));
  const std::vector<Vec> a = test.accelerations(cloth);
  for (const uint32_t vertex : {2u, 3u, 6u}) EXPECT_TRUE(same_bits(a[vertex], Vec{}));
  EXPECT_GT(length(a[4]), 1);
  test.step(dt, 20);
  EXPECT_TRUE(all_finite(test.positions(cloth)));
}

size_t count(const std::string& text, const std::string& word) {
  size_t found = 0;
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST_P(Wind, WithoutTrianglesNothingHappensAndTheLogSaysSoOnce) {
  for (const bool network : {true, false}) {
    TestWorld with(plain_world(GetParam())), without(plain_world(GetParam()));
    for (TestWorld* test : {&with, &without}) {
      if (network) {
        add_particles(*test, {{0, 0, 0}, {1, 0, 0}}, {1, 2, 3});
      } else {
        weft::GridDesc row = flat_grid(1, 6, 0.2);
        row.material.mass.kind = weft::Mass::Kind::total;
        test->add(row, weft::ClothDesc{});
      }
    }
    with.clear_log();
    with.check(with.world().set_wind({{9, 9, 9}}));
    for (int n = 0; n < 10; ++n) {
      with.step(dt);
      without.step(dt);
      with.check(with.world().set_wind({{9, 9, double(n)}}));
    }
    EXPECT_EQ(with.hash(), without.hash());
    EXPECT_EQ(count(with.log(), "\n"), 1u) << with.log();
  }
}

TEST_P(Wind, WithoutAirOrCoefficientsItIsNoEffect) {
  const weft::WindDesc none[] = {{{9, 8, 7}, 0, 1, 1}, {{9, 8, 7}, 1.225, 0, 0}};
  for (const weft::WindDesc& wind : none) {
    TestWorld with(plain_world(GetParam())), without(plain_world(GetParam()));
    with.add(flat_grid(9, 9, 0.2), weft::ClothDesc{});
    without.add(flat_grid(9, 9, 0.2), weft::ClothDesc{});
    with.check(with.world().set_wind(wind));
    with.step(dt, 20);
    without.step(dt, 20);
    EXPECT_EQ(with.hash(), without.hash());
    EXPECT_EQ(with.world().stats().bytes_state, without.world().stats().bytes_state);
    EXPECT_EQ(with.take(with.world().plan()).passes.count,
              without.take(without.world().plan()).passes.count);
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, Wind, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
