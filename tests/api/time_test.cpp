// Uneven frames in even steps, and steps in two halves.
#include <cmath>
#include <limits>

#include "reference/world_helpers.h"

namespace weft_tests::time {
namespace {

weft::GridDesc sheet() {
  weft::GridDesc grid;
  grid.rows = grid.columns = 30;
  return grid;
}
weft::ClothDesc hung() {
  static const weft::Pin pins[] = {{0}, {29}};
  weft::ClothDesc cloth;
  cloth.pins = {pins, 2};
  return cloth;
}

TEST(AdvanceByFrames, UnevenFramesMakeTheStepsOfEvenOnes) {
  TestWorld even, uneven;
  even.add(sheet(), hung());
  uneven.add(sheet(), hung());
  double passed = 0;
  uint32_t steps = 0;
  for (const double frame : {0.007, 0.031, 0.0, 0.0167, 0.0004, 0.05, 0.012, 0.0166}) {
    const weft::Advance made = uneven.take(uneven.world().advance(frame));
    passed += frame;
    steps += made.steps;
    EXPECT_EQ(steps, uint32_t(passed * 60 + 1e-9));
    EXPECT_NEAR(made.alpha, passed * 60 - steps, 1e-9);
    EXPECT_GE(made.alpha, 0);
    EXPECT_LT(made.alpha, 1);
  }
  even.step(1.0 / 60, int(steps));
  EXPECT_EQ(even.hash(), uneven.hash());
  EXPECT_EQ(uneven.world().stats().time_dropped, 0);
}

TEST(AdvanceByFrames, AFrameOfOneStepIsAlwaysOneStep) {
  TestWorld test;
  test.add(sheet(), hung());
  for (int i = 0; i < 500; ++i) ASSERT_EQ(test.take(test.world().advance(1.0 / 60)).steps, 1u) << i;
}

TEST(AdvanceByFrames, WhatIsTooMuchIsDroppedAndTold) {
  weft::WorldDesc desc;
  desc.fixed_dt = 0.01;
  desc.max_steps_per_advance = 3;
  TestWorld test(desc);
  test.add(sheet(), hung());
  const weft::Advance made = test.take(test.world().advance(0.085));
  EXPECT_EQ(made.steps, 3u);
  EXPECT_NEAR(made.alpha, 0.5, 1e-9);
  EXPECT_NEAR(test.world().time(), 0.03, 1e-12);
  EXPECT_NEAR(test.world().stats().time_dropped, 0.05, 1e-12);
  const weft::View<weft::Event> events = test.world().events();
  ASSERT_EQ(events.count, 1u);
  EXPECT_EQ(events[0].type, weft::EventType::time_dropped);
  EXPECT_EQ(test.take(test.world().advance(0.005)).steps, 1u);
  EXPECT_EQ(test.world().events().count, 0u);
}

TEST(AdvanceByFrames, BadFramesAndSettingsAreRefused) {
  TestWorld test;
  test.add(sheet(), hung());
  for (const double dt :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(test.world().advance(dt).status(), weft::Status::invalid_argument);
  EXPECT_EQ(test.world().time(), 0);
  weft::WorldDesc desc;
  desc.fixed_dt = 0;
  EXPECT_EQ(test.context().create_world(desc).status(), weft::Status::invalid_argument);
  desc = {};
  desc.max_steps_per_advance = 0;
  EXPECT_EQ(test.context().create_world(desc).status(), weft::Status::invalid_argument);
}

TEST(StepInHalves, GivesTheBitsOfAStep) {
  TestWorld whole, halves;
  whole.add(sheet(), hung());
  halves.add(sheet(), hung());
  for (int i = 0; i < 20; ++i) {
    whole.step(1.0 / 60);
    halves.check(halves.world().begin_step(1.0 / 60));
    halves.check(halves.world().end_step());
    EXPECT_TRUE(halves.world().step_done());
  }
  EXPECT_EQ(whole.hash(), halves.hash());
  EXPECT_EQ(whole.world().time(), halves.world().time());
  EXPECT_EQ(halves.world().stats().frames, 20u);
}

TEST(StepInHalves, RefusesEverythingElseInBetween) {
  TestWorld test, alone;
  const weft::ClothId cloth = test.add(sheet(), hung());
  alone.add(sheet(), hung());
  test.step(1.0 / 60);
  alone.step(1.0 / 60);
  weft::World& world = test.world();
  EXPECT_EQ(world.end_step(), weft::Status::invalid_argument);
  test.check(world.begin_step(1.0 / 60));
  const weft::Status busy = weft::Status::in_flight;
  std::vector<weft::double3> out(900);
  const uint32_t first[] = {0};
  EXPECT_EQ(world.begin_step(0.01), busy);
  EXPECT_EQ(world.step(0.01), busy);
  EXPECT_EQ(world.step(0), busy);
  EXPECT_EQ(world.prepare(0.01), busy);
  EXPECT_EQ(world.advance(0.01).status(), busy);
  EXPECT_EQ(world.substeps(0.01).status(), busy);
  EXPECT_EQ(world.create_cloth({}).status(), busy);
  EXPECT_EQ(world.destroy_cloth(cloth), busy);
  EXPECT_EQ(world.create_sphere({}).status(), busy);
  EXPECT_EQ(world.destroy_collider({}), busy);
  EXPECT_EQ(world.create_collider_set({}).status(), busy);
  EXPECT_EQ(world.move_collider_set({}, {}), busy);
  EXPECT_EQ(world.destroy_collider_set({}), busy);
  EXPECT_EQ(world.set_skinned_targets(cloth, {}), busy);
  EXPECT_EQ(world.move_collider({}, {}), busy);
  EXPECT_EQ(world.move_pins(cloth, {first, 1}, weft::View<weft::double3>(out.data(), 1)), busy);
  EXPECT_EQ(world.release_pins(cloth, {first, 1}), busy);
  EXPECT_EQ(world.set_forces(cloth, {}), busy);
  EXPECT_EQ(world.set_gravity({0, 0, 0}), busy);
  EXPECT_EQ(world.set_wind({}), busy);
  EXPECT_EQ(world.clear_wind(), busy);
  EXPECT_EQ(world.wake(cloth), busy);
  EXPECT_EQ(world.asleep(cloth).status(), busy);
  EXPECT_EQ(world.stability(cloth).status(), busy);
  EXPECT_EQ(world.plan().status(), busy);
  EXPECT_EQ(world.read_positions(cloth, out.data()), busy);
  EXPECT_EQ(world.read_velocities(cloth, out.data()), busy);
  EXPECT_EQ(world.read_normals(cloth, out.data()), busy);
  EXPECT_EQ(world.read_accelerations(cloth, out.data()), busy);
  EXPECT_EQ(world.mechanics().status(), busy);
  EXPECT_EQ(world.state_hash().status(), busy);
  EXPECT_EQ(world.bind_output(cloth, {}).status(), busy);
  EXPECT_EQ(world.unbind_output({}), busy);
  EXPECT_EQ(world.set_output_memory({}, nullptr), busy);
  EXPECT_EQ(world.write_outputs(), busy);
  EXPECT_TRUE(world.valid(cloth));
  EXPECT_TRUE(world.bounds(cloth));
  EXPECT_EQ(world.time(), 1.0 / 60);
  test.check(world.end_step());
  alone.step(1.0 / 60);
  EXPECT_EQ(test.hash(), alone.hash());
}

TEST(StepInHalves, AStepThatCannotBeginLeavesNothingInFlight) {
  TestWorld test;
  test.add(sheet(), hung());
  EXPECT_EQ(test.world().begin_step(-1), weft::Status::invalid_argument);
  EXPECT_EQ(test.world().end_step(), weft::Status::invalid_argument);
  test.check(test.world().begin_step(0));
  test.check(test.world().end_step());
  EXPECT_EQ(test.world().time(), 0);
}

TEST(StepInHalves, AWorldMayGoWhileItsStepIsInFlight) {
  for (int i = 0; i < 20; ++i) {
    TestWorld test;
    test.add(sheet(), hung());
    test.check(test.world().begin_step(1.0 / 60));
  }
}

TEST(Events, TellWhoFallsAsleepAndWakes) {
  weft::WorldDesc desc;
  desc.gravity = {0, 0, 0};
  TestWorld test(desc);
  weft::ClothDesc cloth = hung();
  cloth.sleep_speed = 0.01;
  cloth.sleep_time = 0.05;
  const weft::ClothId id = test.add(sheet(), cloth);
  int slept = 0;
  for (int i = 0; i < 10; ++i) {
    test.step(1.0 / 60);
    const weft::View<weft::Event> events = test.world().events();
    for (uint32_t e = 0; e < events.count; ++e) {
      EXPECT_EQ(events[e].type, weft::EventType::slept);
      EXPECT_EQ(events[e].cloth, id);
      ++slept;
    }
  }
  EXPECT_EQ(slept, 1);
  test.check(test.world().set_gravity({0, -1, 0}));
  test.step(1.0 / 60);
  ASSERT_EQ(test.world().events().count, 1u);
  EXPECT_EQ(test.world().events()[0].type, weft::EventType::woke);
}

double phase(const weft::World& world, const std::string& name) {
  const weft::Stats stats = world.stats();
  for (uint32_t i = 0; i < stats.phases.count; ++i) {
    if (name == stats.phases[i].name) return stats.phases[i].seconds;
  }
  return -1;
}

TEST(Profile, TellsThePartsOfAStepOnlyWhereItIsAskedFor) {
  if (!on_host()) GTEST_SKIP() << "of the host back end";
  for (const bool asked : {false, true}) {
    weft::WorldDesc desc;
    desc.profile = asked;
    desc.evaluation = weft::Evaluation::scatter;
    TestWorld test(desc);
    test.add(sheet(), hung());
    test.step(1.0 / 60, 20);
    const weft::World& world = test.world();
    if (!asked) {
      EXPECT_EQ(world.stats().phases.count, 3u);
      continue;
    }
    EXPECT_GT(phase(world, "advance.springs"), 0);
    EXPECT_GT(phase(world, "advance.particles"), 0);
    EXPECT_GT(phase(world, "advance.survey"), 0);
    EXPECT_EQ(phase(world, "advance.sums"), 0);
    EXPECT_EQ(phase(world, "advance.hubs"), 0);
    double sum = 0;
    for (const char* part : {"reach", "springs", "hubs", "sums", "particles", "survey"}) {
      sum += phase(world, std::string("advance.") + part);
    }
    EXPECT_LE(sum, phase(world, "advance"));
    EXPECT_GE(sum, 0.5 * phase(world, "advance"));
  }
}

}  // namespace
}  // namespace weft_tests::time
