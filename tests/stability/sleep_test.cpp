// Cloths that fall asleep: when, what wakes them, and that no bit depends on anything else.
#include "reference/effects.h"

#include <functional>

namespace weft_tests::sleep {
namespace {

using Variant = std::tuple<weft::Precision, weft::Form, uint32_t>;
class Sleep : public testing::TestWithParam<Variant> {
 protected:
  weft::WorldDesc desc() const {
    weft::WorldDesc world;
    std::tie(world.precision, world.form, world.substeps) = GetParam();
    world.gravity = {0, 0, 0};
    return world;
  }
};

constexpr double dt = 1.0 / 64;  // 32 frames are half a second without rounding

/// A sheet about `middle`, three of its corners pinned, at rest unless `speed` says otherwise.
weft::ClothId add_sheet(TestWorld& test, Vec middle, double sleep_speed = 0.01,
                        double sleep_time = 0.5, double speed = 0) {
  weft::GridDesc grid;
  grid.rows = 9;
  grid.columns = 12;
  grid.material.stiffness = 1;
  grid.material.mass.value = 0.2;
  const std::vector<weft::Pin> pins{
      {0, weft::Pin::fixed}, {11, weft::Pin::fixed}, {96, weft::Pin::fixed}};
  weft::ClothDesc desc;
  desc.pose.translate = to_weft(middle - Vec{0.5, 0.5, 0});
  desc.pins = pins;
  desc.velocity = {0, 0, speed};
  desc.drag = 2e-3;
  desc.sleep_speed = sleep_speed;
  desc.sleep_time = sleep_time;
  return test.add(grid, desc);
}

bool asleep(TestWorld& test, weft::ClothId id) { return test.take(test.world().asleep(id)); }

TEST_P(Sleep, ComesAfterTheStatedTimeOfCalmAndNotBefore) {
  for (const double sleep_time : {0.0, 0.25, 0.5}) {
    TestWorld test(desc());
    const weft::ClothId id = add_sheet(test, {0, 0, 0}, 0.01, sleep_time);
    for (int n = 1; n <= 40; ++n) {
      test.step(dt);
      ASSERT_EQ(asleep(test, id), n * dt >= sleep_time) << n;
    }
  }
}

TEST_P(Sleep, WaitsUntilNothingIsFasterThanItsSpeed) {
  TestWorld test(desc());
  const weft::ClothId id = add_sheet(test, {0, 0, 0}, 0.02, 0.25, 0.5);
  std::vector<Vec> before = test.positions(id);
  double calm = 0;
  for (int n = 0; n < 4000 && !asleep(test, id); ++n) {
    test.step(dt);
    const std::vector<Vec> x = test.positions(id);
    double fastest = 0;  // on average over the frame; the last substep may be a little faster
    for (size_t i = 0; i < x.size(); ++i)
      fastest = std::max(fastest, length(x[i] - before[i]) / dt);
    calm = fastest < 1.2 * 0.02 ? calm + dt : 0;
    before = x;
  }
  EXPECT_TRUE(asleep(test, id));
  EXPECT_GE(calm, 0.25 - dt / 2);
}

TEST_P(Sleep, DoesNotLeaveALedPinBehind) {
  TestWorld test(desc());
  weft::GridDesc grid;
  grid.rows = grid.columns = 4;
  grid.material.stiffness = 1;
  const std::vector<weft::PinMotion> motions{{{1e-4, 0, 0}, {0, 0, 0}, 0}};
  const std::vector<weft::Pin> pins{{0, 0}};
  weft::ClothDesc sheet;
  sheet.motions = motions;
  sheet.pins = pins;
  sheet.sleep_speed = 0.01;
  sheet.sleep_time = 0.1;
  const weft::ClothId id = test.add(grid, sheet);
  test.step(dt, 64);
  EXPECT_FALSE(asleep(test, id));
  EXPECT_NEAR(test.position(id, 0).x, 1e-4, 1e-7);
}

TEST_P(Sleep, KeepsEveryBit) {
  TestWorld test(desc());
  const weft::ClothId id = add_sheet(test, {0, 0, 0}, 0.05, 0.25, 0.3);
  for (int n = 0; n < 4000 && !asleep(test, id); ++n) test.step(dt);
  ASSERT_TRUE(asleep(test, id));
  const uint64_t hash = test.hash();
  for (int n = 0; n < 50; ++n) {
    test.step(dt);
    ASSERT_EQ(test.hash(), hash) << n;
    ASSERT_TRUE(asleep(test, id));
  }
  for (const Vec v : test.velocities(id)) EXPECT_LE(length(v), 0.06);
}

TEST_P(Sleep, NeverComesWithoutASpeed) {
  TestWorld test(desc());
  const weft::ClothId id = add_sheet(test, {0, 0, 0}, 0, 0);
  test.step(dt, 100);
  EXPECT_FALSE(asleep(test, id));
}

/// Sleeps, is disturbed, and is asked after a step whether it still sleeps.
bool sleeps_through(
    const weft::WorldDesc& desc, const std::function<void(TestWorld&, weft::ClothId)>& disturb,
    const std::function<void(TestWorld&)>& before = [](TestWorld&) {}) {
  TestWorld test(desc);
  const weft::ClothId id = add_sheet(test, {0, 0, 0});
  before(test);
  test.step(dt, 40);
  EXPECT_TRUE(asleep(test, id));
  disturb(test, id);
  test.step(dt);
  return asleep(test, id);
}

TEST_P(Sleep, EndsWithEveryDisturbance) {
  using Disturb = std::function<void(TestWorld&, weft::ClothId)>;
  const std::vector<uint32_t> pin{0}, free_vertex{50};
  const std::vector<weft::double3> target{{-0.6, -0.5, 0}};
  const std::vector<weft::VertexForce> force{{50, {0, 0, 0.01}}};
  const std::pair<const char*, Disturb> all[] = {
      {"wake", [&](TestWorld& t, weft::ClothId id) { t.check(t.world().wake(id)); }},
      {"gravity",
       [&](TestWorld& t, weft::ClothId) {
         t.check(t.world().set_gravity({0, -1, 0}));
       }},
      {"wind",
       [&](TestWorld& t, weft::ClothId) {
         t.check(t.world().set_wind({{0, 0, 3}}));
       }},
      {"forces", [&](TestWorld& t, weft::ClothId id) { t.check(t.world().set_forces(id, force)); }},
      {"move_pins",
       [&](TestWorld& t, weft::ClothId id) {
         t.check(t.world().move_pins(id, pin, weft::View<weft::double3>(target)));
       }},
      {"pinning",
       [&](TestWorld& t, weft::ClothId id) {
         t.check(t.world().move_pins(id, free_vertex, weft::View<weft::double3>(target)));
       }},
      {"release_pins",
       [&](TestWorld& t, weft::ClothId id) { t.check(t.world().release_pins(id, pin)); }},
  };
  for (const auto& [what, disturb] : all) EXPECT_FALSE(sleeps_through(desc(), disturb)) << what;
  EXPECT_TRUE(sleeps_through(desc(), [](TestWorld&, weft::ClothId) {})) << "nothing";
}

TEST_P(Sleep, EndsWhenAMovingColliderReachesTheCloth) {
  for (const Body body : every_body) {
    SCOPED_TRACE(name(body));
    weft::ColliderId id;
    const auto create = [&](TestWorld& test) { id = add_body(test, body, {0, -1, 0}, 0.1); };
    const auto move_by = [&](Vec by, weft::Move how) {
      return [&id, by, how](TestWorld& test, weft::ClothId) {
        test.check(test.world().move_collider(id, {{1, 0, 0}, 0, to_weft(by)}, how));
      };
    };
    for (const weft::Move how : {weft::Move::simulate, weft::Move::teleport}) {
      EXPECT_FALSE(sleeps_through(desc(), move_by({0, 1, 0.05}, how), create));
      EXPECT_TRUE(sleeps_through(desc(), move_by({0, 0.1, 0}, how), create));
    }
    const auto drifts = [&](Vec velocity) {
      return [&, velocity](TestWorld& test, weft::ClothId) {
        add_body(test, body, {0, -1, 0}, 0.1, 0, velocity);
      };
    };
    EXPECT_FALSE(sleeps_through(desc(), drifts({0, 0.9 / dt, 0})));
    EXPECT_TRUE(sleeps_through(desc(), drifts({0, -0.5, 0})));
  }
}

TEST_P(Sleep, EndsTheSameWayInEveryRunAndForAnyNumberOfThreads) {
  uint64_t expected = 0;
  for (const uint32_t threads : {1u, 1u, 2u, 3u}) {
    weft::ContextDesc context = TestWorld::one_thread();
    context.threads = threads;
    TestWorld test(desc(), context);
    const weft::ClothId id = add_sheet(test, {0, 0, 0}, 0.05, 0.25, 0.3);
    for (int i = 0; i < 12; ++i) add_sheet(test, {3.0 * i, 5, 0}, 0, 0, 0.3);  // enough to share
    for (int n = 0; n < 600 && !asleep(test, id); ++n) test.step(dt);
    ASSERT_TRUE(asleep(test, id));
    test.step(dt, 7);
    test.check(test.world().set_gravity({0, 0, -2}));
    test.step(dt, 20);
    EXPECT_FALSE(asleep(test, id));
    if (expected == 0) expected = test.hash();
    EXPECT_EQ(test.hash(), expected) << threads;
  }
}

TEST_P(Sleep, OfOneClothLeavesTheOtherAsItIsAlone) {
  TestWorld both(desc()), alone(desc());
  const weft::ClothId sleeper = add_sheet(both, {0, 0, 0});
  const weft::ClothId other = add_sheet(both, {3, 0, 0}, 0, 0, 0.3);
  const weft::ClothId same = add_sheet(alone, {3, 0, 0}, 0, 0, 0.3);
  for (int n = 0; n < 80; ++n) {
    both.step(dt);
    alone.step(dt);
  }
  EXPECT_TRUE(asleep(both, sleeper));
  const std::vector<Vec> x = both.positions(other), y = alone.positions(same);
  for (size_t i = 0; i < x.size(); ++i) EXPECT_TRUE(same_bits(x[i], y[i])) << i;
}

TEST_P(Sleep, SurvivesWhatComesAndGoesElsewhere) {
  TestWorld test(desc());
  const weft::ClothId id = add_sheet(test, {0, 0, 0}, 0.05, 0.25, 0.3);
  for (int n = 0; n < 4000 && !asleep(test, id); ++n) test.step(dt);
  ASSERT_TRUE(asleep(test, id));
  const std::vector<Vec> before = test.positions(id);
  const auto expect_same = [&](const char* after) {
    for (int n = 0; n < 5; ++n) test.step(dt);
    ASSERT_TRUE(asleep(test, id)) << after;
    const std::vector<Vec> now = test.positions(id, 108);
    for (size_t i = 0; i < now.size(); ++i) ASSERT_TRUE(same_bits(now[i], before[i])) << after;
  };
  const weft::ClothId other = add_sheet(test, {4, 0, 0}, 0, 0, 0.3);
  expect_same("another cloth");
  const weft::ColliderId far = add_body(test, Body::sphere, {40, 0, 0}, 1);
  const weft::ColliderId mesh = add_body(test, Body::mesh, {40, 10, 0}, 1);
  expect_same("far colliders");
  test.check(test.world().destroy_cloth(other));
  expect_same("without the other cloth");
  test.check(test.world().destroy_collider(far));
  test.check(test.world().destroy_collider(mesh));
  expect_same("without the colliders");
}

std::string variant_name(const testing::TestParamInfo<Variant>& info) {
  const auto& [precision, form, substeps] = info.param;
  return std::string(weft::to_string(precision)) +
         (form == weft::Form::summed ? "_summed_" : "_position_") + std::to_string(substeps);
}
TEST_P(Sleep, EndsWithoutTheSpeedThatItBeganWith) {
  for (const int frames : {1, 2, 5}) {
    TestWorld test(desc());
    const weft::ClothId id = add_sheet(test, {0, 0, 0}, 5, 2 * dt, 0.3);
    for (int n = 0; n < 10 && !asleep(test, id); ++n) test.step(dt);
    ASSERT_TRUE(asleep(test, id));
    test.step(dt, frames);
    const std::vector<Vec> x = test.positions(id);
    test.check(test.world().wake(id));
    // Springs alone move it: from rest, in one short step.
    test.step(1e-3);
    const std::vector<Vec> y = test.positions(id);
    double furthest = 0;
    for (size_t i = 0; i < x.size(); ++i) furthest = std::max(furthest, length(y[i] - x[i]));
    EXPECT_LE(furthest, 2e-5) << frames;  // at 0.3 m/s it would be 3e-4 m
  }
}

INSTANTIATE_TEST_SUITE_P(Variants, Sleep,
                         testing::Combine(both_precisions(),
                                          testing::Values(weft::Form::summed, weft::Form::position),
                                          testing::Values(1u, 3u, 4u)),
                         variant_name);

}  // namespace
}  // namespace weft_tests::sleep
