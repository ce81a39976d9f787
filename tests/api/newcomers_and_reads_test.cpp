// What is read of a world follows what was given to it, at once.
#include <cmath>

#include "reference/world_helpers.h"

namespace weft_tests {
namespace {

TEST(ReadAtOnce, AccelerationsHaveTheForcesThatWereSetSinceTheStep) {
  TestWorld test(plain_world(weft::Precision::float64));
  const weft::double3 points[] = {{0, 0, 0}, {1, 0, 0}};
  weft::NetworkDesc net;
  net.positions = weft::View<weft::double3>(points, 2);
  net.material.mass.value = 4;  // 2 kg each
  const weft::VertexForce first[] = {{1, {6, 0, 0}}}, then[] = {{1, {0, 10, 0}}};
  weft::ClothDesc cloth;
  cloth.forces = {first, 1};
  const weft::ClothId id = test.add(net, cloth);
  test.step(0.01);
  expect_near(test.accelerations(id)[1], {3, 0, 0}, 1e-12);
  test.check(test.world().set_forces(id, {then, 1}));
  expect_near(test.accelerations(id)[1], {0, 5, 0}, 1e-12);
}

TEST(ReadAtOnce, BoundsOfANewcomerHoldItsPinsWhereTheirMotionIs) {
  for (const weft::Precision precision : {weft::Precision::float32, weft::Precision::float64}) {
    weft::WorldDesc desc;
    desc.precision = precision;
    TestWorld test(desc);
    weft::GridDesc grid;
    grid.rows = grid.columns = 3;
    test.add(grid, {});
    test.step(0.5, 4);
    const weft::Pin pins[] = {{0, 0}};
    weft::PinMotion motion;
    motion.velocity = {0, 3, 0};
    weft::ClothDesc cloth;
    cloth.pins = {pins, 1};
    cloth.motions = {&motion, 1};
    cloth.pose.translate = {100.1, 0.3, -7.7};
    const weft::ClothId id = test.add(grid, cloth);
    const weft::Bounds b = test.take(test.world().bounds(id));
    EXPECT_NEAR(b.high.y, 0.3 + 6, 1e-5);
    for (const Vec& x : test.positions(id)) {
      EXPECT_TRUE(x.x >= b.low.x && x.y >= b.low.y && x.z >= b.low.z && x.x <= b.high.x &&
                  x.y <= b.high.y && x.z <= b.high.z);
    }
  }
}

TEST(ReadAtOnce, NewcomersStayWhereTheyAreWhenTheirLedPinsAreGivenTargets) {
  TestWorld test;
  weft::GridDesc grid;
  grid.rows = grid.columns = 3;
  test.add(grid, {});
  test.step(0.5, 4);
  const weft::Pin pins[] = {{0, 0}, {8, 0}};
  weft::PinMotion motion;
  motion.velocity = {0, 3, 0};
  weft::ClothDesc cloth;
  cloth.pins = {pins, 2};
  cloth.motions = {&motion, 1};
  const weft::ClothId id = test.add(grid, cloth);
  const std::vector<weft::double3> targets(9, {0, 5, 0});
  test.check(test.world().set_skinned_targets(id, weft::View<weft::double3>(targets)));
  EXPECT_NEAR(test.position(id, 0).y, 6, 1e-6);
  const uint32_t released[] = {8};
  test.check(test.world().release_pins(id, {released, 1}));
  EXPECT_NEAR(test.position(id, 8).y, 7, 1e-6);
}

TEST(ReadAtOnce, ClothThatWakesForOneStepSaysSo) {
  TestWorld test(plain_world(weft::Precision::float64));
  weft::GridDesc grid;
  grid.rows = grid.columns = 3;
  weft::ClothDesc cloth;
  cloth.sleep_speed = 0.1;
  cloth.sleep_time = 0;
  const weft::ClothId id = test.add(grid, cloth);
  test.step(1e-3);
  ASSERT_TRUE(test.take(test.world().asleep(id)));
  test.check(test.world().wake(id));
  test.step(1e-3);
  EXPECT_TRUE(test.take(test.world().asleep(id)));
  const weft::View<weft::Event> events = test.world().events();
  ASSERT_EQ(events.count, 2u);
  EXPECT_EQ(events[0].type, weft::EventType::woke);
  EXPECT_EQ(events[1].type, weft::EventType::slept);
}

/// A sheet with a pin in motion, made after a step, whose pin is led before the next.
uint64_t state_of_a_led_newcomer(bool look_first) {
  weft::WorldDesc desc;
  desc.start = weft::Start::lagged;
  TestWorld test(desc);
  test.step(0.01);
  weft::GridDesc grid;
  grid.rows = grid.columns = 4;
  weft::ClothDesc cloth;
  cloth.spring_damping = 0.05;
  const weft::Pin pins[] = {{5, 0}};
  weft::PinMotion motion;
  motion.velocity = {0.5, 3, 0};
  cloth.pins = {pins, 1};
  cloth.motions = {&motion, 1};
  const weft::ClothId id = test.add(grid, cloth);
  if (look_first) test.hash();
  const std::vector<weft::double3> targets(16, {0.3, 0.4, 0.2});
  test.check(test.world().set_skinned_targets(id, weft::View<weft::double3>(targets)));
  test.step(0.01);
  return test.hash();
}

TEST(ReadAtOnce, LookingAtANewcomerDoesNotChangeItsStart) {
  EXPECT_EQ(state_of_a_led_newcomer(true), state_of_a_led_newcomer(false));
}

}  // namespace
}  // namespace weft_tests
