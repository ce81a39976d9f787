// Inputs that change nothing, and pins that are led, many and in any order.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include "reference/world_helpers.h"

namespace weft_tests::equal_inputs {
namespace {

weft::NetworkDesc one_vertex() {
  static const weft::double3 at[] = {{0, 0, 0}};
  weft::NetworkDesc desc;
  desc.positions = weft::View<weft::double3>(at, 1);
  return desc;
}

/// A sheet that sleeps on a plane, held by one vertex.
struct Sleeper {
  TestWorld test;
  weft::ClothId cloth;
  weft::ColliderId plane;
  weft::ColliderSetId set;
  weft::CapsuleDesc capsule;
  uint32_t pin = 0;
  weft::double3 at;
  weft::WindDesc wind;
  weft::VertexForce force{30, {0, -0.001, 0}};

  Sleeper() {
    wind.velocity = {0, 0, 0};
    test.check(test.world().set_wind(wind));
    plane = test.take(test.world().create_plane({{0, 1, 0}, 0, {0, 0, 0}, 0.5}));
    capsule.a = {0.3, -0.4, -0.5};
    capsule.b = {0.7, -0.4, -0.5};
    capsule.radius = 0.3;
    set = test.take(test.world().create_collider_set(described()));
    weft::GridDesc grid;
    grid.rows = grid.columns = 8;
    weft::ClothDesc desc;
    desc.pose.degrees = -90;
    desc.drag = 0.05;
    desc.spring_damping = 0.05;
    desc.sleep_speed = 0.02;
    desc.sleep_time = 0.2;
    static const weft::Pin pins[] = {{0}};
    desc.pins = {pins, 1};
    cloth = test.add(grid, desc);
    at = to_weft(test.position(cloth, 0));
    give_all();
  }
  weft::ColliderSetDesc described() {
    weft::ColliderSetDesc desc;
    desc.capsules = {&capsule, 1};
    return desc;
  }
  /// Everything that an engine may send whole every frame.
  void give_all() {
    weft::World& world = test.world();
    test.check(world.set_gravity({0, -9.81, 0}));
    test.check(world.set_wind(wind));
    test.check(world.set_forces(cloth, {&force, 1}));
    test.check(world.move_collider(plane, {}));
    test.check(world.move_collider_set(set, described()));
    test.check(world.move_pins(cloth, {&pin, 1}, weft::View<weft::double3>(&at, 1)));
    const std::vector<weft::double3> targets(64, at);
    test.check(world.set_skinned_targets(cloth, weft::View<weft::double3>(targets)));
  }
  bool asleep() { return test.take(test.world().asleep(cloth)); }
};

TEST(EqualInputs, WakeNobody) {
  Sleeper sleeper;
  int frames = 0;
  for (; frames < 600 && !sleeper.asleep(); ++frames) {
    sleeper.give_all();
    sleeper.test.step(1.0 / 60);
  }
  ASSERT_TRUE(sleeper.asleep());
  for (int i = 0; i < 60; ++i) {
    sleeper.give_all();
    sleeper.test.take(sleeper.test.world().advance(1.0 / (i % 2 == 0 ? 59 : 144)));
    ASSERT_TRUE(sleeper.asleep()) << i;
  }
}

TEST(EqualInputs, OthersWake) {
  const std::function<void(Sleeper&)> changes[] = {
      [](Sleeper& s) { s.at.x += 1e-6; },
      [](Sleeper& s) { s.at.y += 1e-6; },
      [](Sleeper& s) { s.at.z += 1e-6; },
      [](Sleeper& s) { s.force.force.z += 1e-6; },
      [](Sleeper& s) { s.force.vertex = 31; },
      [](Sleeper& s) { s.wind.velocity.z += 1e-6; },
      [](Sleeper& s) { s.wind.air_density += 1e-6; },
      [](Sleeper& s) { s.wind.normal += 1e-6; },
      [](Sleeper& s) { s.wind.tangential += 1e-6; },
      [](Sleeper& s) { s.capsule.a.y += 0.3, s.capsule.b.y += 0.3; },
  };
  for (size_t k = 0; k < std::size(changes); ++k) {
    Sleeper sleeper;
    for (int i = 0; i < 600 && !sleeper.asleep(); ++i) sleeper.test.step(1.0 / 60);
    ASSERT_TRUE(sleeper.asleep());
    changes[k](sleeper);
    sleeper.give_all();
    sleeper.test.step(1.0 / 600);
    EXPECT_FALSE(sleeper.asleep()) << "change " << k;
  }
}

TEST(LedPins, AreNotLeftBehindHoweverSlowlyTheyGo) {
  Sleeper sleeper;
  for (int i = 0; i < 3000; ++i) {
    sleeper.at.x += 1e-5;  // slower than sleep_speed
    sleeper.test.check(sleeper.test.world().move_pins(sleeper.cloth, {&sleeper.pin, 1},
                                                      weft::View<weft::double3>(&sleeper.at, 1)));
    sleeper.test.take(sleeper.test.world().advance(1.0 / 144));
  }
  sleeper.test.step(1.0 / 60);
  EXPECT_NEAR(sleeper.test.position(sleeper.cloth, 0).x, sleeper.at.x, 1e-6);
}

TEST(LedPins, TheLastTargetOfAVertexCounts) {
  TestWorld test(plain_world(weft::Precision::float64));
  const weft::ClothId cloth = test.add(one_vertex(), {});
  const uint32_t twice[] = {0, 0};
  const weft::double3 to[] = {{1, 0, 0}, {2, 0, 0}};
  test.check(test.world().move_pins(cloth, {twice, 2}, weft::View<weft::double3>(to, 2)));
  test.step(0.1);
  EXPECT_EQ(test.position(cloth, 0).x, 2);
}

/// Pins are moved and released in any order, with the same end.
TEST(ManyPins, OrderDoesNotMatter) {
  weft::GridDesc grid;
  grid.rows = grid.columns = 20;
  std::vector<uint64_t> hashes;
  for (const int order : {0, 1, 2}) {
    TestWorld test;
    const weft::ClothId cloth = test.add(grid, {});
    std::vector<uint32_t> vertices(300);
    std::iota(vertices.begin(), vertices.end(), 50u);
    if (order == 1) std::reverse(vertices.begin(), vertices.end());
    if (order == 2) std::shuffle(vertices.begin(), vertices.end(), std::mt19937(7));
    std::vector<weft::double3> to;
    for (const uint32_t v : vertices) to.push_back({0.05 * (v % 20), 0.01 * v, 0.3});
    test.check(test.world().move_pins(cloth, vertices, weft::View<weft::double3>(to)));
    test.step(1.0 / 60);
    vertices.resize(150);
    if (order == 0) {
      std::iota(vertices.begin(), vertices.end(), 200u);
    } else {
      std::iota(vertices.rbegin(), vertices.rend(), 200u);
    }
    test.check(test.world().release_pins(cloth, vertices));
    test.step(1.0 / 60, 3);
    hashes.push_back(test.hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(ManyPins, MoveAndGoInLinearTime) {
  const auto seconds_of = [](uint32_t edge) {
    TestWorld test;
    weft::GridDesc grid;
    grid.rows = grid.columns = edge;
    const weft::ClothId cloth = test.add(grid, {});
    std::vector<uint32_t> vertices(edge * edge);
    std::iota(vertices.rbegin(), vertices.rend(), 0u);
    const std::vector<weft::double3> to(vertices.size(), weft::double3{0, 1, 0});
    test.hash();  // the state is on the device
    const auto begin = std::chrono::steady_clock::now();
    test.check(test.world().move_pins(cloth, vertices, weft::View<weft::double3>(to)));
    test.check(test.world().release_pins(cloth, vertices));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  double least = 1e9;
  for (int i = 0; i < 3; ++i) least = std::min(least, seconds_of(300));
  EXPECT_LE(least, 0.5);  // 90,000 pins; by erasing one by one it takes 10 s
}

}  // namespace
}  // namespace weft_tests::equal_inputs
