// A step that has more to tell than there was room for, without memory.
#include <cstdlib>

#include "reference/world_helpers.h"

namespace weft_tests::event_memory {
namespace {

using weft::Status;

/// Fails at one call and at all that follow, while it is `armed`.
struct Memory {
  long calls = 0, fails_at = 0;
  bool armed = false;

  static void* allocate(void* user, std::size_t bytes, std::size_t alignment) {
    auto& memory = *static_cast<Memory*>(user);
    if (memory.armed && ++memory.calls >= memory.fails_at) return nullptr;
    return std::aligned_alloc(alignment, (bytes + alignment) / alignment * alignment);
  }
  static void deallocate(void*, void* at, std::size_t) { std::free(at); }
};

/// A step in which more fall asleep than events ever had room for takes that room before it begins.
TEST(EventMemory, AStepOfManyEventsFailsBeforeItBegins) {
  if (!on_host()) GTEST_SKIP() << "the runtime of a GPU has its own ways";
  constexpr uint32_t cloths = 60;
  weft::WorldDesc still = plain_world(weft::Precision::float64);
  bool went_well = false;
  for (long k = 1; k < 200 && !went_well; ++k) {
    Memory memory;
    weft::ContextDesc desc = TestWorld::one_thread();
    desc.allocator = {&memory, Memory::allocate, Memory::deallocate};
    TestWorld test(still, desc);
    weft::ClothDesc calm;
    calm.fabric = test.cook(weft::GridDesc());
    calm.sleep_speed = 1;
    calm.sleep_time = 0.015;
    weft::ClothId last;
    for (uint32_t c = 0; c < cloths; ++c) last = test.add(calm);
    test.step(0.01);
    memory.fails_at = k;
    memory.armed = true;
    const Status status = test.world().step(0.01);
    memory.armed = false;
    went_well = status == Status::ok;
    if (!went_well) {
      ASSERT_EQ(status, Status::out_of_memory) << k;
      ASSERT_EQ(test.world().time(), 0.01) << "failed and went on, at allocation " << k;
      ASSERT_FALSE(test.take(test.world().asleep(last))) << k;
      test.step(0.01);
    }
    ASSERT_EQ(test.world().time(), 0.02) << k;
    ASSERT_EQ(test.world().events().count, cloths) << k;
  }
  EXPECT_TRUE(went_well);
}

}  // namespace
}  // namespace weft_tests::event_memory
