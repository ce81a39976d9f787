#include "plan/device_arrays.h"

#include <memory>

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

/// A world's arrays, cut from memory of their own.
struct Cut {
  explicit Cut(const WorldShape& world, int stride = 1)
      : memory(device_bytes(world, stride) + 128) {
    void* base = memory.data();
    size_t room = memory.size();
    begin = static_cast<char*>(std::align(128, 1, base, room));
    arrays = cut<float>(world, stride, begin);
  }
  size_t at(const float* view) const { return size_t(reinterpret_cast<const char*>(view) - begin); }

  std::vector<char> memory;
  char* begin = nullptr;
  DeviceArrays<float> arrays;
};

TEST(DeviceArrays, AnEffectThatNoClothNamesHasNoArray) {
  const Cut cut(grid_world(64));
  const Simulation<float>& sim = cut.arrays.sim;
  EXPECT_EQ(sim.forces.force.data, nullptr);
  EXPECT_EQ(sim.rows.neighbour, nullptr);
  EXPECT_EQ(sim.rows.stiffness, nullptr);
  EXPECT_EQ(sim.colliders.spheres, nullptr);
  EXPECT_EQ(sim.colliders.near, nullptr);
  EXPECT_EQ(sim.activity, nullptr);
  EXPECT_EQ(sim.pins.of_block, nullptr);
  EXPECT_EQ(sim.pins.base.data, nullptr);
  EXPECT_EQ(sim.x[2].data, nullptr);
  EXPECT_EQ(sim.d[1].data, sim.d[0].data);
  EXPECT_EQ(cut.arrays.before.data, nullptr);
}

TEST(DeviceArrays, SizesAndViewsComeFromTheSameWalk) {
  WorldShape world = grid_world(40);
  ClothShape mesh{};
  mesh.kind = KernelKind::mesh_per_spring;
  mesh.particles = 77;
  mesh.row_entries = 384;
  mesh.spring_damping = mesh.sleeps = true;
  mesh.moving_pin_blocks = 1;
  mesh.parts = 1;
  world.cloths.push_back(mesh);
  world.colliders[0] = 3;
  world.interpolate = true;
  for (const int stride : {1, 4}) {
    const Cut cut(world, stride);
    EXPECT_EQ(cut.arrays.bytes, device_bytes(world, stride));
    // The last array of all ends where the memory does.
    const size_t end = cut.at(cut.arrays.before.data) + 3 * 1696 * sizeof(float);
    EXPECT_LE(end, cut.arrays.bytes);
    EXPECT_GT(end + 7 * 1024, cut.arrays.bytes);
  }
}

TEST(DeviceArrays, EachEffectAddsItsOwnArraysOnly) {
  const auto bytes = [](const WorldShape& world) { return device_bytes(world, 1); };
  const size_t bare = bytes(grid_world(64));
  WorldShape damped = grid_world(64);
  damped.cloths[0].spring_damping = true;
  const size_t vectors = bytes(damped) - bare;
  EXPECT_GE(vectors, 12u * 64 * 64);
  EXPECT_LE(vectors, 12u * (64 * 64 + 2 * 160 + 64));
  WorldShape forced = grid_world(64);
  forced.cloths[0].parts = 1u << int(Part::forces);
  EXPECT_GE(bytes(forced) - bare, 12u * 64 * 64);
  EXPECT_LE(bytes(forced) - bare, 12u * (64 * 64 + 64));
  WorldShape sphere = grid_world(64);
  sphere.colliders[0] = 1;  // with its lists and a region for each block
  EXPECT_LE(bytes(sphere) - bare, 32u * 128 + 6 * 128);
  WorldShape blown = grid_world(64);
  blown.wind = blown.cloths[0].triangles = true;
  EXPECT_EQ(bytes(blown) - bare, vectors);
  WorldShape sleepy = grid_world(64);
  sleepy.cloths[0].sleeps = true;
  EXPECT_LE(bytes(sleepy) - bare, 128u);
  WorldShape shown = grid_world(64);
  shown.normals = true;
  EXPECT_EQ(bytes(shown), bare);
}

TEST(DeviceArrays, GuardBandsHoldEveryStencilLoad) {
  for (const int stride : {1, 4}) {
    const WorldShape world = grid_world(100);
    const Cut cut(world, stride);
    const Simulation<float>& sim = cut.arrays.sim;
    const size_t guard = size_t(world.cloths[0].guard) * size_t(stride) * sizeof(float);
    EXPECT_GE(cut.at(sim.x[0].data), guard);
    const size_t elements = size_t(counts_of(world).particles);
    const size_t last_plane = stride == 1 ? 2 * sim.x[0].pitch * sizeof(float) : 0;
    const size_t end =
        cut.at(sim.x[0].data) + last_plane + elements * size_t(stride) * sizeof(float);
    EXPECT_LE(end + guard, cut.at(sim.x[1].data) - guard + 128);
    EXPECT_LE(end + guard, cut.arrays.bytes);
  }
}

TEST(DeviceArrays, DoubleTakesTwiceTheRoomOfFloat) {
  WorldShape world = grid_world(256);
  const double narrow = double(device_bytes(world, 1));
  world.precision = Precision::float64;
  const double ratio = double(device_bytes(world, 1)) / narrow;
  EXPECT_GT(ratio, 1.8);
  EXPECT_LE(ratio, 2.0);
}

TEST(Places, OfAClothAreTheCountsOfThoseBeforeIt) {
  WorldShape world = grid_world(9);  // 81 particles: 96 with padding
  ClothShape mesh{};
  mesh.kind = KernelKind::mesh_uniform;
  mesh.particles = 33;
  mesh.row_entries = 640;
  mesh.parts = 1;
  mesh.motions = 2;
  world.cloths.push_back(mesh);
  world.cloths.push_back(mesh);
  const auto places = places_of(world);
  ASSERT_EQ(places.size(), 4u);
  EXPECT_EQ(places[1].particles, 96);
  EXPECT_EQ(places[1].row_slices, 0);
  EXPECT_EQ(places[1].motions, 1) << "the first motion is none";
  EXPECT_EQ(places[2].particles, 160);
  EXPECT_EQ(places[2].row_slices, 2);
  EXPECT_EQ(places[2].row_entries, 640);
  EXPECT_EQ(places[2].part[0], 64);
  EXPECT_EQ(places[2].motions, 3);
  const Counts whole = counts_of(world);
  EXPECT_EQ(places[3].particles, whole.particles);
  EXPECT_EQ(places[3].row_entries, whole.row_entries);
  EXPECT_EQ(places[3].part[0], whole.part[0]);
  EXPECT_EQ(places[3].survey_groups, whole.survey_groups);
  EXPECT_EQ(whole.first_row_block, 3);
}

/// A list that forgets a member is told from one that does not.
struct Whole {
  const int* a;
  Vec3Array<float> b;
  int c;
  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    array(a, n.particles);
    array(b, n.particles);
    array.number(c, 3);
  }
};
struct Short {
  const int* a;
  const int* b;
  int numbers[3];
  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    array(a, n.particles);
    array.later(numbers);
  }
};
TEST(Members, AForgottenViewIsNoticed) {
  EXPECT_EQ(members_of<Whole>(), 3u);
  EXPECT_EQ((listed_members_of<Whole, Counts>()), 3u);
  EXPECT_EQ(members_of<Short>(), 5u);
  EXPECT_EQ((listed_members_of<Short, Counts>()), 4u);
}

}  // namespace
}  // namespace weft::plan
