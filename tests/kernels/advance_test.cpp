// The kernel as a plain functor: one call with 32 lanes (the CPU's way) and 32 calls with one lane
// (a warp's way) must give the same bits.
#include "kernels/advance.h"
#include "kernels/normals.h"

#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

namespace weft {
using namespace WEFT_BACKEND_NS;

namespace {

/// Two blocks of a grid 8 columns wide, with every stage that a kernel has.
struct TwoBlocks {
  static constexpr int particles = 64, guard = 32, pitch = particles + 2 * guard;

  TwoBlocks() {
    for (int k = 0; k < 4; ++k) arrays[k].assign(3 * pitch, 0.0f);
    for (int i = 0; i < particles; ++i) {
      set(0, i,
          {0.1f * float(i % 8), 0.1f * float(i / 8) + 0.003f * float(i % 5), 0.01f * float(i % 3)});
      set(1, i, {0.001f, -0.002f, 0.0005f * float(i % 7)});
      w.push_back(i == 3 || i == 40 ? 0.0f : 10.0f + float(i % 4));
      uint16_t bits = 0;
      const auto offsets = Seed12::offsets();
      for (int n = 0; n < 12; ++n) {
        const int r = i / 8 + offsets.row[n], c = i % 8 + offsets.column[n];
        if (r >= 0 && c >= 0 && r < 8 && c < 8) bits = uint16_t(bits | (1 << n));
      }
      presence.push_back(bits);
    }
    cloth.columns = 8;
    for (int n = 0; n < 12; ++n) {
      cloth.stiffness[n] = 50;
      cloth.rest[n] = 0.1f;
    }
    cloth.drag = 0.02f;
    cloth.drag_model = int(Drag::central);
    cloth.spring_damping = 0.01f;
    for (int& part : cloth.part) part = no_part;
    cloth.in_wind = 1;
    const int axial[4] = {1 << 6, 1 << 8, 1 << 5, 1 << 3};  // east, north, west, south in Seed12
    for (int k = 0; k < 4; ++k) cloth.axial[k] = axial[k];
    for (int k = 0; k < 5; ++k) cloth.collider_count[k] = 1;
  }
  Vec3Array<float> view(int k) { return {arrays[k].data() + guard, pitch}; }
  void set(int k, int i, Vec3<float> v) { store(view(k), i, v); }

  AdvanceParticles<float, GridSprings<float, Seed12>> kernel() {
    Simulation<float> sim{};
    sim.cloths = &cloth;
    sim.block = {block_cloth, block_inner};
    sim.presence = presence.data();
    sim.inverse_mass = w.data();
    sim.colliders.spheres = &sphere;
    cloth.end = 64;
    sim.colliders.planes = &plane;
    sim.colliders.capsules = &capsule;
    sim.colliders.cylinders = &cylinder;
    sim.colliders.boxes = &box;
    sim.activity = &activity;
    sim.reach = reach;
    StepParams<float> step{};
    step.dt = 0.002f;
    step.ratio = 1;
    step.a_factor = 0.002f * 0.002f;
    step.gravity = {0, -9.81f, 0};
    step.wind = {{3, 1, 4}, 0.1f, 0.002f};
    return {{sim, {view(0), view(1), view(2), view(3)}, step},
            {presence.data(), block_inner},
            {presence.data(), block_inner},
            0};
  }

  std::vector<float> arrays[4], w;
  std::vector<uint16_t> presence;
  ClothParams<float> cloth{};
  int32_t block_cloth[2] = {0, 0};
  uint8_t block_inner[2] = {0, 0};
  ClothActivity<float> activity{};
  BlockReach<float> reach[2] = {};
  Sphere<float> sphere{{0.35f, 0.3f, 0}, 0.15f, {{0, 0, 0}, 0, 0.01f, -1, {0, 0, 0}}};
  Plane<float> plane{{0, 1, 0}, 0.02f, {{0.1f, 0, 0}, 0.3f, 0.01f, -1, {0, 0, 0}}};
  Capsule<float> capsule{
      {0.6f, 0.5f, 0}, {0.1f, 0, 0}, 100, 0.1f, {0, 1, 0}, {{0, 0, 0}, 0.2f, 0.01f, -1, {0, 0, 0}}};
  Cylinder<float> cylinder{{0.05f, 0.6f, -0.2f},
                           {0, 0, 1},
                           0.4f,
                           0.08f,
                           {1, 0, 0},
                           {{0, 0, 0}, 0, 0.01f, -1, {0, 0, 0}}};
  Box<float> box{{0.7f, 0.1f, 0},
                 {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                 {0.06f, 0.05f, 0.2f},
                 {{0, 0, 0}, 0.5f, 0.01f, -1, {0, 0, 0}}};
};

TEST(AdvanceParticles, AWarpAndABlockGiveTheSameBits) {
  TwoBlocks wide, narrow;
  const auto blocks = wide.kernel();
  for (int b = 0; b < 2; ++b) blocks(b, 0, Lanes<32>{});
  const auto warps = narrow.kernel();
  for (int b = 0; b < 2; ++b) {
    for (int lane = 0; lane < 32; ++lane) warps(b, lane, Lanes<1>{});
  }
  EXPECT_EQ(wide.arrays[2], narrow.arrays[2]);
  EXPECT_EQ(wide.arrays[3], narrow.arrays[3]);
  EXPECT_NE(wide.arrays[2], wide.arrays[0]);
}

TEST(VertexNormals, AWarpAndABlockGiveTheSameBits) {
  TwoBlocks grid;
  const GridFan<float> fan{grid.presence.data(), grid.block_inner};
  const VertexNormals<float, GridFan<float>> wide{fan,          &grid.cloth,  grid.block_cloth,
                                                  grid.view(0), grid.view(2), 0};
  const VertexNormals<float, GridFan<float>> narrow{fan,          &grid.cloth,  grid.block_cloth,
                                                    grid.view(0), grid.view(3), 0};
  for (int b = 0; b < 2; ++b) {
    wide(b, 0, Lanes<32>{});
    for (int lane = 0; lane < 32; ++lane) narrow(b, lane, Lanes<1>{});
  }
  EXPECT_EQ(grid.arrays[2], grid.arrays[3]);
  EXPECT_GT(std::abs(load(grid.view(2), 10).z), 0.5f);
}

TEST(AdvanceParticles, APinDoesNotMoveAndKeepsNoDisplacement) {
  TwoBlocks grid;
  const auto kernel = grid.kernel();
  for (int b = 0; b < 2; ++b) kernel(b, 0, Lanes<32>{});
  for (const int pin : {3, 40}) {
    const auto before = load(grid.view(0), pin), after = load(grid.view(2), pin);
    EXPECT_EQ(std::memcmp(&before, &after, sizeof before), 0);
    EXPECT_EQ(load(grid.view(3), pin).y, 0);
  }
}

TEST(AdvanceParticles, APinStaysWhereItIsWhenItsNeighboursAreNotFinite) {
  TwoBlocks grid;
  grid.set(0, 4, {INFINITY, 0, 0});
  grid.set(1, 3, {NAN, NAN, NAN});
  const auto before = load(grid.view(0), 3);
  const auto kernel = grid.kernel();
  for (int b = 0; b < 2; ++b) kernel(b, 0, Lanes<32>{});
  const auto after = load(grid.view(2), 3);
  EXPECT_EQ(std::memcmp(&before, &after, sizeof before), 0);
}

TEST(AdvanceParticles, FreeParticlesEndOutsideTheColliders) {
  TwoBlocks grid;
  const auto kernel = grid.kernel();
  for (int b = 0; b < 2; ++b) kernel(b, 0, Lanes<32>{});
  int touched = 0;
  for (int i = 0; i < 64; ++i) {
    if (grid.w[size_t(i)] == 0) continue;
    const auto x = load(grid.view(2), i);
    EXPECT_GE(x.y, 0.02f - 1e-7f);
    const auto from = x - grid.sphere.center;
    EXPECT_GE(square_root(dot(from, from)), 0.15f - 1e-6f);
    touched += x.y < 0.0201f;
  }
  EXPECT_GE(touched, 6);
}

}  // namespace
}  // namespace weft
