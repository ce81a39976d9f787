// A frame of a running game takes nothing from the heap: this program counts operator new.
#include <atomic>
#include <cstdlib>
#include <new>

#include "reference/world_helpers.h"

static std::atomic<long> allocations{0};

static void* counted(std::size_t bytes) {
  ++allocations;
  if (void* memory = std::malloc(bytes ? bytes : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t bytes) { return counted(bytes); }
void* operator new[](std::size_t bytes) { return counted(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace weft_tests {
namespace {

TEST(Heap, AFrameAllocatesNothing) {
  if (!on_host()) GTEST_SKIP() << "the runtime of a GPU has its own ways";
  weft::WorldDesc desc;
  desc.interpolate = true;
  TestWorld test(desc);
  weft::GridDesc grid;
  grid.rows = grid.columns = 40;
  const weft::Pin pins[] = {{0, 0}, {39}};
  weft::PinMotion motion;
  motion.amplitude = {0, 0.1, 0};
  motion.omega = 3;
  weft::ClothDesc cloth;
  cloth.pins = {pins, 2};
  cloth.motions = {&motion, 1};
  cloth.sleep_speed = 1e-4;
  const weft::ClothId id = test.add(grid, cloth);
  weft::SphereDesc sphere;
  sphere.center = {0.5, -0.3, 0.1};
  sphere.radius = 0.3;
  const weft::ColliderId ball = test.take(test.world().create_sphere(sphere));
  test.take(test.world().create_plane({}));
  test.check(test.world().set_wind({}));
  std::vector<float> buffer(1600 * 6);
  weft::OutputDesc output;
  output.layout.position = {weft::Format::f32x3, 0, 24};
  output.layout.normal = {weft::Format::f32x3, 12, 24};
  output.memory = buffer.data();
  test.take(test.world().bind_output(id, output));
  weft::Pose pose;
  const auto frame = [&](int n) {
    pose.translate.x = 0.01 * n;
    (void)test.world().move_collider(ball, pose);
    (void)test.world().set_gravity({0, -9.81, 0.01 * n});
    const auto advanced = test.world().advance(1.0 / 50);
    (void)test.world().write_outputs(advanced->alpha);
    (void)test.world().bounds(id);
    (void)test.world().events();
    (void)test.world().stats();
  };
  for (int n = 0; n < 20; ++n) frame(n);
  const long before = allocations;
  EXPECT_GT(before, 0);
  for (int n = 20; n < 80; ++n) frame(n);
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace weft_tests
