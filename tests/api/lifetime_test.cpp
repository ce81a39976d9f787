// Who asks a world what from another thread, who destroys it when, and what its ids are worth.
#include <atomic>
#include <chrono>
#include <set>
#include <thread>

#include "reference/world_helpers.h"

#include "weft/debug_draw.hpp"

namespace weft_tests {
namespace {

weft::GridDesc sheet_of(uint32_t n) {
  weft::GridDesc grid;
  grid.rows = grid.columns = n;
  return grid;
}

TEST(AnyThread, MayAskWhileAnotherStepsAndChangesTheWorld) {
  TestWorld test, alone;
  const weft::ClothId kept = test.add(sheet_of(12), {});
  alone.add(sheet_of(12), {});
  std::atomic<bool> stop{false};
  std::atomic<int> asked{0}, wrong{0};
  const auto ask = [&] {
    double last = 0;
    while (!stop) {
      const auto bounds = test.world().bounds(kept);
      const weft::Stats stats = test.world().stats();
      const double now = test.world().time();
      const bool sane = bounds && bounds->low.x <= bounds->high.x && test.world().valid(kept) &&
                        now >= last && stats.particles >= 144 && stats.particles % 36 == 0;
      if (!sane) ++wrong;
      (void)test.world().events();
      (void)test.world().step_done();
      last = now;
      ++asked;
    }
  };
  std::thread one(ask), another(ask);
  weft::ClothDesc guest;
  guest.fabric = test.cook(sheet_of(6));
  for (int i = 0; i < 40 || asked < 100; ++i) {
    const weft::ClothId id = test.add(guest);
    test.step(1.0 / 60);
    test.check(test.world().begin_step(1.0 / 60));
    test.check(test.world().end_step());
    test.check(test.world().destroy_cloth(id));
    alone.step(1.0 / 60, 2);
  }
  stop = true;
  one.join();
  another.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(test.hash(), alone.hash());
}

/// What runs begin_step: weft's thread, a thread of the caller's, or the call itself.
enum class Launcher { own, callers, none };

void slow_launch(void* user, void (*fn)(void*), void* context, const char*) {
  *static_cast<std::thread*>(user) = std::thread([fn, context] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    fn(context);
  });
}
void alone_for(void*, uint32_t count, uint32_t, void (*fn)(void*, uint32_t, uint32_t),
               void* context, const char*) {
  fn(context, 0, count);
}

TEST(Lifetime, AWorldWaitsForItsStep) {
  for (const Launcher launcher : {Launcher::own, Launcher::callers, Launcher::none}) {
    for (const bool assigned : {false, true}) {
      std::thread launched;
      weft::ContextDesc desc = TestWorld::one_thread();
      if (launcher != Launcher::own) {
        desc.jobs.workers = 1;
        desc.jobs.parallel_for = alone_for;
        desc.jobs.user = &launched;
      }
      if (launcher == Launcher::callers) desc.jobs.launch = slow_launch;
      auto context = weft::Context::create(desc);
      ASSERT_TRUE(context);
      {
        auto world = context->create_world();
        weft::ClothDesc cloth;
        auto fabric = context->cook(sheet_of(40));
        cloth.fabric = *fabric;
        ASSERT_TRUE(world->create_cloth(cloth));
        ASSERT_EQ(world->begin_step(0.2), weft::Status::ok);
        if (assigned) *world = weft::World();
      }
      EXPECT_EQ(context->bytes_allocated(), 0u) << "the world has not gone";
      if (launched.joinable()) launched.join();
    }
  }
}

TEST(Lifetime, WhatDrawsMayDestroy) {
  auto context = weft::Context::create(TestWorld::one_thread());
  auto world = context->create_world();
  weft::ClothDesc cloth;
  {
    auto fabric = context->cook(sheet_of(5));
    cloth.fabric = *fabric;
  }
  const auto id = world->create_cloth(cloth);
  cloth.fabric = weft::Fabric();
  ASSERT_TRUE(world->create_sphere({}));
  struct Painter {
    weft::Context* context;
    weft::World* world;
    weft::ClothId cloth;
    int lines = 0;
  } painter{&*context, &*world, *id};
  weft::DebugDraw draw;
  draw.user = &painter;
  draw.line = [](void* user, weft::double3, weft::double3, uint32_t) {
    auto& p = *static_cast<Painter*>(user);
    if (++p.lines == 3) (void)p.world->destroy_cloth(p.cloth);
    if (p.lines == 5) *p.world = weft::World();
    if (p.lines == 7) *p.context = weft::Context();
  };
  EXPECT_EQ(world->debug_draw(draw), weft::Status::ok);
  EXPECT_GT(painter.lines, 150);  // the springs, the box round them, and the sphere
}

TEST(Lifetime, ADivergedClothIsDrawnWithoutLinesToNowhere) {
  weft::WorldDesc desc;
  desc.unsafe = true;
  desc.substeps = 1;
  TestWorld test(desc);
  const weft::Pin pin{0};
  weft::ClothDesc cloth;
  cloth.pins = {&pin, 1};
  test.add(sheet_of(6), cloth);
  weft::Status status = weft::Status::ok;
  for (int i = 0; i < 3000 && status == weft::Status::ok; ++i) status = test.world().step(0.1);
  ASSERT_EQ(status, weft::Status::diverged);
  ASSERT_GT(test.world().events().count, 0u);
  EXPECT_EQ(test.world().step(0.1), weft::Status::diverged);
  EXPECT_GT(test.world().events().count, 0u) << "how it was lost is still told";
  weft::DebugDraw draw;
  int wild = 0;
  draw.user = &wild;
  draw.line = [](void* user, weft::double3 a, weft::double3 b, uint32_t) {
    for (const double c : {a.x, a.y, a.z, b.x, b.y, b.z}) {
      if (!std::isfinite(c)) ++*static_cast<int*>(user);
    }
  };
  EXPECT_EQ(test.world().debug_draw(draw), weft::Status::ok);
  EXPECT_EQ(wild, 0);
}

TEST(Ids, OfSeventyThousandWorldsAreAllDifferent) {
  auto context = weft::Context::create(TestWorld::one_thread());
  auto first = context->create_world();
  const auto id = first->create_sphere({});
  std::set<std::pair<uint32_t, uint32_t>> seen{{id->index, id->generation}};
  for (int i = 0; i < 70000; ++i) {
    auto world = context->create_world();
    const auto other = world->create_sphere({});
    ASSERT_TRUE(seen.insert({other->index, other->generation}).second) << i;
  }
  auto last = context->create_world();
  EXPECT_EQ(last->destroy_collider(*id), weft::Status::invalid_handle);
}

TEST(Ids, OfDifferentKindsAreDifferent) {
  TestWorld test;
  const weft::ClothId cloth = test.add(sheet_of(3), {});
  const weft::ColliderId ball = test.take(test.world().create_sphere({}));
  const weft::ColliderSetId set = test.take(test.world().create_collider_set({}));
  const std::set<std::pair<uint32_t, uint32_t>> all{
      {cloth.index, cloth.generation}, {ball.index, ball.generation}, {set.index, set.generation}};
  EXPECT_EQ(all.size(), 3u);
}

TEST(Messages, NameTheCallAndTheCloth) {
  TestWorld test;
  test.add(sheet_of(3), {});
  const weft::ClothId second = test.add(sheet_of(3), {});
  const uint32_t vertex = 99;
  EXPECT_NE(test.world().release_pins(second, {&vertex, 1}), weft::Status::ok);
  EXPECT_NE(test.log().find("release_pins, cloth 1: "), std::string::npos) << test.log();
  test.clear_log();
  weft::SphereDesc sphere;
  sphere.radius = -1;
  EXPECT_FALSE(test.world().create_sphere(sphere));
  EXPECT_NE(test.log().find("create_sphere: "), std::string::npos) << test.log();
}

TEST(Messages, OfEveryFrameAreToldRarely) {
  TestWorld test;
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(test.world().step(-1), weft::Status::invalid_argument);
  }
  int lines = 0;
  for (const char c : test.log()) lines += c == '\n';
  EXPECT_GE(lines, 8);
  EXPECT_LE(lines, 16);
  EXPECT_NE(test.log().find("[said 512 times]"), std::string::npos) << test.log();
  test.clear_log();
  EXPECT_EQ(test.world().step(-2), weft::Status::invalid_argument);
  EXPECT_FALSE(test.log().empty()) << "another message is told at once";
}

TEST(Views, OfTooManyElementsAreRefused) {
  TestWorld test;
  const weft::double3 point{0, 0, 0};
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(&point, (size_t(1) << 32) + 1);
  EXPECT_EQ(test.context().cook(network).status(), weft::Status::invalid_argument);
  EXPECT_NE(test.log().find("2^32"), std::string::npos) << test.log();
}

TEST(Tables, OfHalfABillionSubstepsAreRefused) {
  for (const bool turns : {false, true}) {
    weft::WorldDesc desc;
    desc.substeps = 500000000;
    TestWorld test(desc);
    const weft::Pin pin{0, 0};
    weft::PinMotion motion;
    motion.velocity = {1, 0, 0};
    weft::ClothDesc cloth;
    cloth.pins = {&pin, turns ? 0u : 1u};
    cloth.motions = {&motion, turns ? 0u : 1u};
    test.add(sheet_of(2), cloth);
    if (turns) {
      weft::BoxDesc box;
      box.center = {0, -9, 0};
      const weft::ColliderId id = test.take(test.world().create_box(box));
      weft::Pose pose;
      pose.degrees = 10;
      test.check(test.world().move_collider(id, pose));
    }
    EXPECT_EQ(test.world().prepare(1), weft::Status::invalid_argument) << turns;
    EXPECT_NE(test.log().find("500000000 substeps"), std::string::npos) << test.log();
    EXPECT_LT(test.world().stats().bytes_total, 1u << 24);
  }
}

TEST(Stats, CountTheTimeOfProcessors) {
  TestWorld test;
  test.add(sheet_of(60), {});
  test.step(1.0 / 60, 10);
  const weft::Stats stats = test.world().stats();
  EXPECT_GT(stats.cpu_seconds, 0);
  if (on_host()) {
    EXPECT_LT(stats.cpu_seconds, 1.05 * stats.step_seconds + 1e-3) << "one thread";
  }
}

}  // namespace
}  // namespace weft_tests
