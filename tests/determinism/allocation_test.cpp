// The allocator hook: everything goes through it and comes back, and a step allocates nothing.
#include "determinism/scenes.h"

#include <cstdlib>
#include <map>

namespace weft_tests {
namespace {

/// Counts, and checks that blocks come back with their size and were aligned as asked.
struct CountingAllocator {
  uint64_t calls = 0;
  uint64_t bytes = 0;
  uint64_t wrong = 0;
  std::map<void*, size_t> held;

  weft::Allocator hook() {
    return {this,
            [](void* user, size_t size, size_t alignment) -> void* {
              auto& self = *static_cast<CountingAllocator*>(user);
              ++self.calls;
              const size_t rounded = (size + alignment - 1) / alignment * alignment;
              void* memory = std::aligned_alloc(std::max(alignment, alignof(void*)),
                                                std::max(rounded, alignof(void*)));
              self.held[memory] = size;
              self.bytes += size;
              return memory;
            },
            [](void* user, void* memory, size_t size) {
              auto& self = *static_cast<CountingAllocator*>(user);
              const auto block = self.held.find(memory);
              if (block == self.held.end() || block->second != size) {
                ++self.wrong;
                return;
              }
              self.bytes -= size;
              self.held.erase(block);
              std::free(memory);
            }};
  }
};

class Allocation : public testing::TestWithParam<std::tuple<Scene, uint32_t>> {};

TEST_P(Allocation, AStepAllocatesNothing) {
  const auto [scene, threads] = GetParam();
  CountingAllocator counting;
  uint64_t own = 0;
  {
    weft::ContextDesc context = TestWorld::one_thread();
    context.threads = threads;
    context.allocator = counting.hook();
    {  // What a context itself lies in is not what it made.
      const weft::Result<weft::Context> empty = weft::Context::create(context);
      ASSERT_TRUE(empty);
      own = counting.bytes - empty->bytes_allocated();
    }
    TestWorld test(scene_world({}), context);
    add_scene(test, scene);
    test.check(test.world().prepare(1.0 / 60));
    test.step(1.0 / 60);
    EXPECT_GT(counting.calls, 0u);
    const uint64_t before = counting.calls, bytes = counting.bytes;
    test.step(1.0 / 60, 50);
    test.step(0);
    test.check(test.world().set_gravity({0, -1.62, 0}));
    test.step(1.0 / 60, 5);
    EXPECT_EQ(counting.calls, before);
    EXPECT_EQ(counting.bytes, bytes);
    // The memory of a GPU does not come from the caller's allocator, but it counts.
    const uint64_t device = on_host() ? 0 : test.world().stats().bytes_state;
    EXPECT_EQ(test.context().bytes_allocated() + own, counting.bytes + device);
    const uint64_t planned = test.take(test.world().plan()).bytes_total;
    EXPECT_EQ(planned, test.world().stats().bytes_total);
  }
  EXPECT_EQ(counting.bytes, 0u);
  EXPECT_TRUE(counting.held.empty());
  EXPECT_EQ(counting.wrong, 0u);
}

std::string allocation_name(const testing::TestParamInfo<Allocation::ParamType>& info) {
  return std::string(name(std::get<0>(info.param))) + "_threads" +
         std::to_string(std::get<1>(info.param));
}
INSTANTIATE_TEST_SUITE_P(Scenes, Allocation,
                         testing::Combine(testing::ValuesIn(all_scenes), testing::Values(1u, 3u)),
                         allocation_name);

TEST(AllocationCycles, ThousandClothsLeaveNoGrowth) {
  CountingAllocator counting;
  {
    weft::ContextDesc context = TestWorld::one_thread();
    context.allocator = counting.hook();
    TestWorld test(scene_world({}), context);
    Sheet sheet;
    sheet.noise = 0.01;
    const auto cycle = [&](int n) {
      const weft::ClothId cloth =
          n % 2 ? sheet.add_to(test) : sheet.add_network_to(test);  // cooks a fabric, too
      test.step(1.0 / 60);
      test.check(test.world().destroy_cloth(cloth));
    };
    for (int n = 0; n < 10; ++n) cycle(n);
    const uint64_t bytes = counting.bytes, blocks = counting.held.size();
    for (int n = 0; n < 1000; ++n) cycle(n);
    EXPECT_LE(counting.bytes, bytes);
    EXPECT_LE(counting.held.size(), blocks);
  }
  EXPECT_EQ(counting.bytes, 0u);
  EXPECT_EQ(counting.wrong, 0u);
}

TEST(AllocationCycles, ThousandWorldsAndFabricsLeaveNoGrowth) {
  CountingAllocator counting;
  weft::ContextDesc desc = TestWorld::one_thread();
  desc.allocator = counting.hook();
  {
    weft::Result<weft::Context> context = weft::Context::create(desc);
    ASSERT_TRUE(context);
    uint64_t bytes = 0;
    for (int n = 0; n < 1000; ++n) {
      weft::Result<weft::World> world = context->create_world({});
      ASSERT_TRUE(world);
      weft::ClothDesc cloth;
      weft::Result<weft::Fabric> fabric = context->cook(weft::GridDesc{});
      cloth.fabric = *fabric;
      ASSERT_TRUE(world->create_cloth(cloth));
      ASSERT_EQ(world->step(0.01), weft::Status::ok);
      if (n == 10) bytes = counting.bytes;
      if (n > 10) {
        ASSERT_LE(counting.bytes, bytes) << n;
      }
    }
  }
  EXPECT_EQ(counting.bytes, 0u);
}

}  // namespace
}  // namespace weft_tests
