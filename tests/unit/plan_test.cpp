#include "plan/plan.h"

#include <gtest/gtest.h>

namespace weft::plan {
namespace {

ClothShape grid(uint32_t particles) {
  ClothShape c{};
  c.kind = KernelKind::seed12;
  c.particles = particles;
  c.directed_springs = 12ull * particles;
  return c;
}

TEST(Plan, ABareSheetIsOnePassPerSubstepAndOnePerFrame) {
  WorldShape world;
  world.cloths = {grid(4096)};
  const Plan plan = compile_plan(world);
  ASSERT_EQ(plan.passes.size(), 2u);
  EXPECT_STREQ(plan.passes[0].stage, "advance");
  EXPECT_STREQ(plan.passes[0].per, "substep");
  EXPECT_STREQ(plan.passes[1].stage, "survey");
  EXPECT_STREQ(plan.passes[1].per, "frame");
  EXPECT_EQ(plan.passes[0].kernel, "grid_seed12_float32");
  EXPECT_EQ(plan.passes[0].count, 4096u);
  // x, d read and written, and the inverse mass: 52 bytes, and the block tables.
  EXPECT_NEAR(plan.passes[0].bytes_per_particle, 52, 0.5);
}

TEST(Plan, ManySmallClothsAreOneLaunch) {
  WorldShape world;
  for (int i = 0; i < 1000; ++i) world.cloths.push_back(grid(64));
  const Plan plan = compile_plan(world);
  ASSERT_EQ(plan.ranges.size(), 1u);
  EXPECT_EQ(plan.ranges[0].count, 2000);
  EXPECT_EQ(plan.passes[0].count, 64000u);
}

/// The pass of a substep.
Pass advance(const WorldShape& world) {
  for (const Pass& pass : compile_plan(world).passes) {
    if (std::string(pass.stage) == "advance") return pass;
  }
  return {};
}

TEST(Plan, EveryNamedEffectShowsInThePassAndCosts) {
  WorldShape world;
  world.cloths = {grid(1024)};
  world.cloths[0].triangles = true;
  const Pass bare = advance(world);
  world.colliders[0] = world.colliders[5] = 1;
  world.wind = true;
  world.cloths[0].drag = world.cloths[0].spring_damping = true;
  const Pass more = advance(world);
  EXPECT_EQ(more.kernel,
            "grid_seed12_float32 +wind +spring_damping +drag +sphere_colliders +mesh_colliders");
  EXPECT_GT(more.flops_per_particle, bare.flops_per_particle + 6 * 62);
}

TEST(Plan, OnlyCollidersAskForReachAndOnlyWantedNormalsForAPass) {
  const auto has = [](const WorldShape& world, const char* stage) {
    for (const Pass& pass : compile_plan(world).passes) {
      if (std::string(pass.stage) == stage) return true;
    }
    return false;
  };
  WorldShape world;
  world.cloths = {grid(1024)};
  EXPECT_FALSE(has(world, "reach"));
  EXPECT_FALSE(has(world, "normals"));
  world.colliders[1] = 1;
  EXPECT_TRUE(has(world, "reach"));
  EXPECT_FALSE(has(world, "normals"));
  world.normals = true;
  EXPECT_TRUE(has(world, "normals"));
}

TEST(Plan, KindsOfClothAreSeparateRanges) {
  WorldShape world;
  world.cloths = {grid(100), grid(100)};
  ClothShape mesh{};
  mesh.kind = KernelKind::mesh_uniform;
  mesh.particles = 50;
  mesh.row_entries = 384;
  world.cloths.push_back(mesh);
  const Plan plan = compile_plan(world);
  ASSERT_EQ(plan.ranges.size(), 2u);
  EXPECT_EQ(plan.ranges[1].first, 8);
  EXPECT_EQ(plan.ranges[1].count, 2);
}

}  // namespace
}  // namespace weft::plan
