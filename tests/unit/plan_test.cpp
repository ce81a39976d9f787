#include "plan/device_arrays.h"
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
  world.contact_grids = 1;
  const Pass more = advance(world);
  EXPECT_EQ(more.kernel,
            "grid_seed12_float32 +wind +spring_damping +drag +contacts +sphere_colliders "
            "+mesh_colliders");
  EXPECT_EQ(more.bytes_per_particle, bare.bytes_per_particle + 6 * sizeof(float));
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

TEST(Plan, SelfCollisionIsPassesOfItsOwnThatAllCost) {
  const auto stages = [](const WorldShape& world) {
    std::string all;
    for (const Pass& pass : compile_plan(world).passes) {
      all += std::string(pass.stage) + " ";
      EXPECT_GT(pass.bytes_per_particle, 0) << pass.stage;
      EXPECT_EQ(pass.count, 5120u) << pass.stage;
    }
    return all;
  };
  WorldShape world;
  world.cloths = {grid(4096), grid(1024)};
  EXPECT_EQ(stages(world), "advance survey ");
  EXPECT_EQ(first_list_entries(world), 0);
  const size_t bare = device_bytes(world, 1);
  world.contact_grids = 1;
  EXPECT_EQ(stages(world), "keep advance bounds keys sort cells rows count push apply survey ");
  EXPECT_GE(first_list_entries(world), 2 * 5120);
  EXPECT_GT(device_bytes(world, 1), bare + 5120 * 100);
  world.contact_grids = 8;
  world.staggered = true;
  EXPECT_EQ(stages(world), "keep advance keys sort rows count push apply survey ");
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

ClothShape scattering(uint32_t particles) {
  ClothShape c{};
  c.kind = KernelKind::scatter_mesh;
  c.particles = particles;
  c.directed_springs = 6ull * particles;
  c.edges = 3ull * particles + 32;
  c.row_entries = 6ll * particles;
  return c;
}

TEST(Plan, AScatterIsAPassOverSpringsAndOneOverParticles) {
  WorldShape world;
  world.cloths = {scattering(1024)};
  const Plan plan = compile_plan(world);
  ASSERT_EQ(plan.passes.size(), 3u);
  EXPECT_STREQ(plan.passes[0].stage, "springs");
  EXPECT_EQ(plan.passes[0].kernel, "edge_forces_float32 native");
  EXPECT_EQ(plan.passes[0].count, 3072u);
  EXPECT_EQ(plan.passes[1].kernel, "scatter_mesh_float32");
  EXPECT_EQ(plan.passes[1].count, 1024u);
}

TEST(Plan, SumsOfLowPrecisionAreAPassOfTheirOwnAndAtomicsAreNone) {
  WorldShape world;
  world.cloths = {scattering(1024)};
  for (const Accumulation a : {Accumulation::float16, Accumulation::float24,
                               Accumulation::float24_all, Accumulation::fixed8}) {
    world.accumulation = a;
    const Plan plan = compile_plan(world);
    ASSERT_EQ(plan.passes.size(), 4u);
    EXPECT_STREQ(plan.passes[1].stage, "sums");
  }
  for (const Accumulation a : {Accumulation::atomic, Accumulation::fixed64}) {
    world.accumulation = a;
    EXPECT_EQ(compile_plan(world).passes.size(), 3u);
  }
}

TEST(Plan, HubsAreAPassOnlyWhereThereAreSome) {
  WorldShape world;
  world.cloths = {grid(1024)};
  for (const Pass& pass : compile_plan(world).passes) EXPECT_STRNE(pass.stage, "hubs");
  world.cloths[0].kind = KernelKind::mesh_uniform;
  world.cloths[0].hubs = 1;
  world.cloths[0].hub_chunks = 3;
  world.cloths[0].hub_springs = 2500;
  const Plan plan = compile_plan(world);
  EXPECT_STREQ(plan.passes[0].stage, "hubs");
  EXPECT_EQ(plan.passes[0].count, 2500u);
}

}  // namespace
}  // namespace weft::plan
