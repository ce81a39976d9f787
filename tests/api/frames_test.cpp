// What an engine gives once a frame, and where the steps inside of the frame find it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include "reference/world_helpers.h"

namespace weft_tests::frames {
namespace {

/// A cape of 0.8 m x 1.2 m that hangs from its top row.
struct Cape {
  static constexpr uint32_t edge = 16;
  TestWorld test;
  weft::ClothId cloth;
  std::vector<uint32_t> top;
  std::vector<weft::double3> base;

  explicit Cape(const weft::WorldDesc& desc, double speed) : test(desc) {
    weft::GridDesc grid;
    grid.rows = grid.columns = edge;
    grid.width = 0.8;
    grid.height = 1.2;
    grid.material.stiffness = weft::Stiffness(300, 80, 5);
    grid.material.mass.value = 0.4;
    std::vector<weft::Pin> pins;
    for (uint32_t c = 0; c < edge; ++c) {
      top.push_back(edge * (edge - 1) + c);
      pins.push_back({top.back()});
    }
    weft::ClothDesc made;
    made.pins = pins;
    made.velocity = {speed, 0, 0};
    made.spring_damping = 0.2;
    cloth = test.add(grid, made);
    for (const uint32_t v : top) base.push_back(to_weft(test.position(cloth, v)));
  }
  void lead(double by) {
    std::vector<weft::double3> to = base;
    for (weft::double3& t : to) t.x += by;
    test.check(
        test.world().move_pins(cloth, weft::View<uint32_t>(top), weft::View<weft::double3>(to)));
  }
};

struct Ride {
  double stretch = 0, least_lag = 1e9, most_lag = -1e9;
};

/// A bar at constant speed, told once a frame; frames from `length`.
template <class Length>
Ride ride(double speed, Length length) {
  weft::WorldDesc desc;
  desc.interpolate = true;
  desc.max_steps_per_advance = 10;
  Cape cape(desc, speed);
  std::vector<weft::float3> drawn(Cape::edge * Cape::edge);
  weft::OutputDesc out;
  out.layout.position = {weft::Format::f32x3, 0, sizeof(weft::float3)};
  out.memory = drawn.data();
  cape.test.take(cape.test.world().bind_output(cape.cloth, out));
  Ride seen;
  double passed = 0;
  for (int frame = 0; passed < 5; ++frame) {
    passed += length(frame);
    cape.lead(speed * passed);
    const weft::Advance made = cape.test.take(cape.test.world().advance(length(frame)));
    cape.test.check(cape.test.world().write_outputs(made.alpha));
    if (passed < 2) continue;
    EXPECT_NEAR(made.time, passed - 1.0 / 60, 1e-6);
    const double lag = speed * passed - (double(drawn[cape.top[0]].x) - cape.base[0].x);
    seen.least_lag = std::min(seen.least_lag, lag);
    seen.most_lag = std::max(seen.most_lag, lag);
    seen.stretch = std::max(seen.stretch, cape.test.mechanics().stretch);
  }
  return seen;
}

TEST(Frames, ALedClothHangsAlikeAtEveryFrameRate) {
  const double speed = 4;
  const Ride at_60 = ride(speed, [](int) { return 1.0 / 60; });
  EXPECT_NEAR(at_60.least_lag, speed / 60, 1e-3);
  for (const double fps : {20.0, 30.0, 50.0, 59.0, 61.0, 144.0, 1000.0}) {
    const Ride seen = ride(speed, [&](int) { return 1 / fps; });
    EXPECT_LE(seen.stretch, 1.1 * at_60.stretch) << fps;
    EXPECT_NEAR(seen.least_lag, speed / 60, 1e-3) << fps;
    EXPECT_NEAR(seen.most_lag, speed / 60, 1e-3) << fps;
  }
}

TEST(Frames, ALedClothHangsAlikeAtUnevenFrames) {
  const double speed = 4;
  const Ride even = ride(speed, [](int) { return 1.0 / 60; });
  const Ride uneven = ride(speed, [](int n) { return 0.003 + 0.03 * ((n * 7919) % 13) / 12; });
  EXPECT_LE(uneven.stretch, 1.1 * even.stretch);
  EXPECT_NEAR(uneven.least_lag, speed / 60, 1e-3);
  EXPECT_NEAR(uneven.most_lag, speed / 60, 1e-3);
}

/// A free vertex that lies on a collider without springs rises with it.
double lift(const std::function<void(TestWorld&, double height)>& raise, TestWorld& test,
            weft::ClothId cloth, double fps) {
  double worst = 0;
  for (int n = 1; n <= 120; ++n) {
    raise(test, 1.5 * n / fps);
    test.take(test.world().advance(1 / fps));
    // At the time that has been simulated, the vertex is where the collider is on its way.
    worst = std::max(worst, std::fabs(test.positions(cloth, 1)[0].y - 1.5 * test.world().time()));
  }
  return worst;
}

weft::NetworkDesc one_vertex() {
  static const weft::double3 at[] = {{0, 0, 0}};
  weft::NetworkDesc desc;
  desc.positions = weft::View<weft::double3>(at, 1);
  return desc;
}

TEST(Frames, StepsFindCollidersAndSetsOnTheirWay) {
  for (const double fps : {24.0, 59.0, 90.0}) {
    weft::WorldDesc desc;
    desc.max_steps_per_advance = 10;
    desc.substeps = 4;
    {
      TestWorld test(desc);
      const weft::ClothId cloth = test.add(one_vertex(), {});
      const weft::ColliderId plane = test.take(test.world().create_plane({}));
      const auto raise = [&](TestWorld& t, double height) {
        weft::Pose pose;
        pose.translate = {0, height, 0};
        t.check(t.world().move_collider(plane, pose));
      };
      EXPECT_LE(lift(raise, test, cloth, fps), 1e-4) << fps;
    }
    {
      TestWorld test(desc);
      const weft::ClothId cloth = test.add(one_vertex(), {});
      weft::BoxDesc box;
      box.center = {0, -1, 0};
      weft::ColliderSetDesc set;
      set.boxes = {&box, 1};
      const weft::ColliderSetId id = test.take(test.world().create_collider_set(set));
      const auto raise = [&](TestWorld& t, double height) {
        box.center.y = height - 1;
        t.check(t.world().move_collider_set(id, set));
      };
      EXPECT_LE(lift(raise, test, cloth, fps), 1e-4) << fps;
    }
  }
}

TEST(Frames, AtAFrameRateAboveTheStepsNoStepComesLate) {
  TestWorld test;
  test.add(one_vertex(), {});
  uint64_t steps = 0;
  for (uint64_t n = 1; n <= 2880; ++n) {
    steps += test.take(test.world().advance(1.0 / 144)).steps;
    ASSERT_EQ(steps, n * 60 / 144) << n;
  }
}

TEST(Frames, AFailingAdvanceOwesNothing) {
  weft::WorldDesc desc;
  desc.substeps = 1;  // too few for the sheet
  desc.max_steps_per_advance = 100;
  TestWorld test(desc);
  weft::GridDesc grid;
  grid.rows = grid.columns = 16;
  grid.material.stiffness = 1e5;
  const weft::ClothId cloth = test.add(grid, {});
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(test.world().advance(0.3).status(), weft::Status::unstable_step);
  }
  test.check(test.world().destroy_cloth(cloth));
  EXPECT_EQ(test.take(test.world().advance(0)).steps, 0u);
  EXPECT_EQ(test.take(test.world().advance(1.5 / 60)).steps, 1u);
}

TEST(Frames, EventsOfAllStepsAreToldOnce) {
  weft::WorldDesc desc;
  desc.gravity = {0, 0, 0};
  desc.max_steps_per_advance = 100;
  TestWorld test(desc);
  weft::ClothDesc still;
  still.sleep_speed = 1;
  still.sleep_time = 0.02;
  test.add(one_vertex(), still);
  still.sleep_time = 0.1;
  test.add(one_vertex(), still);
  const auto slept = [&] {
    uint32_t count = 0;
    for (uint32_t e = 0; e < test.world().events().count; ++e) {
      count += test.world().events()[e].type == weft::EventType::slept ? 1 : 0;
    }
    return count;
  };
  test.take(test.world().advance(10.0 / 60));  // both fall asleep, in different steps
  EXPECT_EQ(slept(), 2u);
  test.take(test.world().advance(0.25 / 60));  // no step
  EXPECT_EQ(slept(), 0u);
}

TEST(Frames, HugeFramesDropAFiniteTime) {
  TestWorld test;
  test.add(one_vertex(), {});
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(test.take(test.world().advance(1e308)).steps, 4u);
    EXPECT_TRUE(std::isfinite(test.world().stats().time_dropped));
  }
}

TEST(MaxSubsteps, DropsTheRestOfAStepAndSaysSo) {
  weft::GridDesc grid;
  grid.rows = grid.columns = 8;
  grid.material.stiffness = 1e7;
  weft::WorldDesc desc;
  desc.max_substeps = 10;
  TestWorld test(desc);
  test.add(grid, {});
  const double bound = test.world().stability().dt_bound;
  const double dt = 100 * 0.9 * bound;
  EXPECT_EQ(test.take(test.world().substeps(dt)), 10u);
  test.step(dt);
  EXPECT_NEAR(test.world().time(), 9 * bound, 1e-12);
  EXPECT_LE(test.world().stats().dt_last, 0.9 * bound);
  EXPECT_NEAR(test.world().stats().time_dropped, dt - 9 * bound, 1e-12);
  ASSERT_EQ(test.world().events().count, 1u);
  EXPECT_EQ(test.world().events()[0].type, weft::EventType::time_dropped);
  test.step(5 * 0.9 * bound);
  EXPECT_EQ(test.world().events().count, 0u);
  EXPECT_EQ(test.take(test.world().substeps(9 * bound)), 10u);  // at the limit nothing is lost
}

TEST(MaxSubsteps, AsManyAsAreFixedMustBeAllowed) {
  TestWorld test;
  weft::WorldDesc desc;
  desc.substeps = 9;
  desc.max_substeps = 8;
  EXPECT_EQ(test.context().create_world(desc).status(), weft::Status::invalid_argument);
  EXPECT_NE(test.log().find("max_substeps"), std::string::npos) << test.log();
  desc.max_substeps = 9;
  test.take(test.context().create_world(desc));
}

}  // namespace
}  // namespace weft_tests::frames
