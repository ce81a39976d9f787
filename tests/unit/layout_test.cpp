#include "plan/layout.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace weft::plan {
namespace {

WorldShape grid_world(uint32_t n) {
  WorldShape world;
  ClothShape cloth{};
  cloth.kind = KernelKind::seed12;
  cloth.particles = n * n;
  cloth.guard = 2 * int(n) + 2;
  world.cloths.push_back(cloth);
  return world;
}

TEST(Layout, AnEffectThatNoClothNamesHasNoBuffer) {
  const Layout l = lay_out(grid_world(64), 1);
  EXPECT_EQ(l.force.offset, absent);
  EXPECT_EQ(l.neighbour, absent);
  EXPECT_EQ(l.stiffness, absent);
  for (const size_t array : l.colliders) EXPECT_EQ(array, absent);
  EXPECT_EQ(l.block_pins, absent);
  EXPECT_EQ(l.pin_base.offset, absent);
  EXPECT_EQ(l.x[2].offset, absent);
  EXPECT_EQ(l.d[1].offset, l.d[0].offset);
}

TEST(Layout, EachEffectAddsItsOwnBuffersOnly) {
  const size_t bare = lay_out(grid_world(64), 1).bytes;
  WorldShape damped = grid_world(64);
  damped.cloths[0].spring_damping = true;
  const size_t vectors = lay_out(damped, 1).bytes - bare;
  EXPECT_GE(vectors, 12u * 64 * 64);
  EXPECT_LE(vectors, 12u * (64 * 64 + 2 * 160 + 64));
  WorldShape forced = grid_world(64);
  forced.cloths[0].constant_forces = true;
  EXPECT_GE(lay_out(forced, 1).bytes - bare, 12u * 64 * 64);
  WorldShape sphere = grid_world(64);
  sphere.colliders[0] = 1;  // with its lists and a region for each block
  EXPECT_LE(lay_out(sphere, 1).bytes - bare, 32u * 128 + 6 * 128);
  WorldShape blown = grid_world(64);
  blown.wind = blown.cloths[0].triangles = true;
  EXPECT_EQ(lay_out(blown, 1).bytes - bare, vectors);
  WorldShape sleepy = grid_world(64);
  sleepy.cloths[0].sleeps = true;
  EXPECT_LE(lay_out(sleepy, 1).bytes - bare, 128u);
  WorldShape shown = grid_world(64);
  shown.normals = true;
  EXPECT_EQ(lay_out(shown, 1).bytes, bare);
}

TEST(Layout, GuardBandsHoldEveryStencilLoad) {
  for (const int step : {1, 4}) {
    const WorldShape world = grid_world(100);
    const Layout l = lay_out(world, step);
    const size_t guard = size_t(world.cloths[0].guard) * size_t(step) * sizeof(float);
    EXPECT_GE(l.x[0].offset, guard);
    const size_t elements = world.blocks() * block_size;
    const size_t last_plane = step == 1 ? 2 * l.x[0].pitch * sizeof(float) : 0;
    const size_t end = l.x[0].offset + last_plane + elements * size_t(step) * sizeof(float);
    EXPECT_LE(end + guard, l.x[1].offset - guard + 128);
    EXPECT_LE(end + guard, l.bytes);
  }
}

TEST(Layout, DoubleTakesTwiceTheRoomOfFloat) {
  WorldShape world = grid_world(256);
  const double narrow = double(lay_out(world, 1).bytes);
  world.precision = Precision::float64;
  const double ratio = double(lay_out(world, 1).bytes) / narrow;
  EXPECT_GT(ratio, 1.8);
  EXPECT_LE(ratio, 2.0);
}

}  // namespace
}  // namespace weft::plan
