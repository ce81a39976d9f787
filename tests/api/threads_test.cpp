// The thread rules of the public headers, held: worlds side by side, cooking from many threads, one
// thread at a time in a world, and a step in flight.
#include <atomic>
#include <thread>

#include "reference/world_helpers.h"

namespace weft_tests {
namespace {

weft::GridDesc sheet(uint32_t n) {
  weft::GridDesc grid;
  grid.rows = grid.columns = n;
  return grid;
}

uint64_t simulate(weft::Context& context, uint32_t n) {
  auto fabric = context.cook(sheet(n));
  auto world = context.create_world({});
  weft::ClothDesc cloth;
  cloth.fabric = *fabric;
  const weft::Pin pins[] = {{0}, {n - 1}};
  cloth.pins = {pins, 2};
  if (!world || !world->create_cloth(cloth)) return 0;
  for (int i = 0; i < 10; ++i)
    if (world->step(1.0 / 60) != weft::Status::ok) return 0;
  return *world->state_hash();
}

TEST(Threads, WorldsOfOneContextRunSideBySide) {
  weft::ContextDesc desc = TestWorld::one_thread();
  desc.threads = 2;
  auto context = weft::Context::create(desc);
  ASSERT_TRUE(context);
  const uint64_t alone = simulate(*context, 40);
  ASSERT_NE(alone, 0u);
  uint64_t hashes[4] = {};
  std::vector<std::thread> threads;
  for (uint64_t& hash : hashes) threads.emplace_back([&] { hash = simulate(*context, 40); });
  for (std::thread& t : threads) t.join();
  for (const uint64_t hash : hashes) EXPECT_EQ(hash, alone);
}

TEST(Threads, ASecondOneInAWorldIsRefusedAndChangesNothing) {
  TestWorld test, alone;
  const weft::ClothId cloth = test.add(sheet(64), {});
  alone.add(sheet(64), {});
  std::atomic<bool> stop{false};
  std::atomic<int> refused{0}, other{0};
  std::thread second([&] {
    while (!stop) {
      const weft::Status status = test.world().set_gravity({0, -9.81, 0});
      if (status == weft::Status::wrong_thread) ++refused;
      if (status != weft::Status::wrong_thread && status != weft::Status::ok) ++other;
    }
  });
  int stepped = 0;
  while (stepped < 30 || (refused == 0 && stepped < 3000)) {
    const weft::Status status = test.world().step(1.0 / 60);
    if (status == weft::Status::ok) ++stepped;
    if (status != weft::Status::ok) {
      ASSERT_EQ(status, weft::Status::wrong_thread);
    }
  }
  stop = true;
  second.join();
  EXPECT_GT(refused, 0);
  EXPECT_EQ(other, 0);
  alone.step(1.0 / 60, stepped);
  EXPECT_EQ(test.hash(), alone.hash());
  EXPECT_TRUE(test.world().valid(cloth));
}

TEST(Threads, AStepInFlightRunsWhileTheCallerLooksOn) {
  TestWorld test, alone;
  const weft::ClothId cloth = test.add(sheet(64), {});
  alone.add(sheet(64), {});
  for (int i = 0; i < 10; ++i) {
    test.check(test.world().begin_step(1.0 / 60));
    while (!test.world().step_done()) {
      test.take(test.world().bounds(cloth));
      (void)test.world().stats();
      (void)test.world().time();
    }
    test.check(test.world().end_step());
  }
  alone.step(1.0 / 60, 10);
  EXPECT_EQ(test.hash(), alone.hash());
}

TEST(Threads, AWorldMayChangeHands) {
  TestWorld test, alone;
  test.add(sheet(20), {});
  alone.add(sheet(20), {});
  for (int i = 0; i < 4; ++i) std::thread([&] { test.step(1.0 / 60, 2); }).join();
  alone.step(1.0 / 60, 8);
  EXPECT_EQ(test.hash(), alone.hash());
}

}  // namespace
}  // namespace weft_tests
