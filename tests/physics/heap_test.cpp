// Layers of cloth that lie on each other: they keep their distance and their order. HC70.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reference/world_helpers.h"

namespace weft_tests::heap {
namespace {

constexpr double distance = 0.01;
constexpr uint32_t side = 8;

struct Heap {
  uint32_t layers = 10;
  double gap = 1.05 * distance;  ///< m, between the layers at the start
  double shift = 0;              ///< m, of every other layer along both axes
  weft::Precision precision = weft::Precision::float32;
  uint32_t substeps = 18;
  double gravity = 9.81;
  double lowest = 0.001;  ///< m
  double friction = 0;
};

/// Sheets of 1.1 distances between neighbours above the plane z = 0.
struct HeapWorld {
  TestWorld test;
  std::vector<weft::ClothId> layers;

  static weft::WorldDesc world_of(const Heap& heap) {
    weft::WorldDesc desc;
    desc.gravity = {0, 0, -heap.gravity};
    desc.precision = heap.precision;
    desc.substeps = heap.substeps;
    return desc;
  }
  explicit HeapWorld(const Heap& heap) : test(world_of(heap)) {
    weft::GridDesc grid;
    grid.rows = grid.columns = side;
    grid.width = grid.height = 1.1 * distance * (side - 1);
    grid.stencil = weft::Stencil::classic12;
    grid.material.mass.value = 0.08 * side * side / 1024;
    grid.material.stiffness = {20, 8, 0.5};
    for (uint32_t j = 0; j < heap.layers; ++j) {
      weft::ClothDesc cloth;
      cloth.spring_damping = 0.001;
      cloth.pose.translate = {heap.shift * (j % 2), heap.shift * (j % 2),
                              heap.lowest + heap.gap * j};
      layers.push_back(test.add(grid, cloth));
    }
    weft::PlaneDesc plane;
    plane.normal = {0, 0, 1};
    plane.friction = heap.friction;
    test.take(test.world().create_plane(plane));
    weft::SelfCollisionDesc contact;
    contact.distance = distance;
    contact.friction = heap.friction;
    test.check(test.world().set_self_collision(contact));
  }
  /// Least distance of two particles of different layers.
  double nearest() {
    double least = INFINITY;
    for (size_t j = 0; j < layers.size(); ++j) {
      for (size_t k = j + 1; k < layers.size(); ++k) {
        for (const Vec p : test.positions(layers[j])) {
          for (const Vec q : test.positions(layers[k])) {
            least = std::min(least, reference::length(p - q));
          }
        }
      }
    }
    return least;
  }
  std::vector<double> heights() {
    std::vector<double> out;
    for (const weft::ClothId id : layers) {
      double sum = 0;
      for (const Vec p : test.positions(id)) sum += p.z;
      out.push_back(sum / (side * side));
    }
    return out;
  }
  double fastest() {
    double most = 0;
    for (const weft::ClothId id : layers) {
      for (const Vec v : test.velocities(id)) most = std::max(most, reference::length(v));
    }
    return most;
  }
};

class HeapOfCloth : public BothPrecisions {};

// Aligned layers stand on each other as balls on balls do: friction has to hold them there.
TEST_P(HeapOfCloth, OfFourAlignedLayersKeepsItsGaps) {
  Heap heap;
  heap.precision = GetParam();
  heap.layers = 4;
  heap.substeps = 40;
  heap.friction = 0.4;
  HeapWorld world(heap);
  world.test.step(1.0 / 60, 120);
  const std::vector<double> heights = world.heights();
  for (size_t j = 1; j < heights.size(); ++j) {
    EXPECT_GT(heights[j] - heights[j - 1], 0.95 * distance) << "layer " << j;
    EXPECT_LT(heights[j] - heights[j - 1], 1.05 * distance) << "layer " << j;
  }
  EXPECT_LT(world.fastest(), 0.03) << "they stand still, and are said to";
  const std::vector<Vec> before = world.test.positions(world.layers[3]);
  world.test.step(1.0 / 60, 30);
  const std::vector<Vec> after = world.test.positions(world.layers[3]);
  for (size_t v = 0; v < before.size(); ++v)
    EXPECT_LT(reference::length(after[v] - before[v]), 1e-4);
}

// Ten slide into each other's hollows sooner or later; none sinks through another, also where
// substeps are long.
TEST_P(HeapOfCloth, OfTenAlignedLayersKeepsItsOrder) {
  Heap heap;
  heap.precision = GetParam();
  heap.friction = 0.4;
  HeapWorld world(heap);
  world.test.step(1.0 / 60, 180);
  const std::vector<double> heights = world.heights();
  for (size_t j = 1; j < heights.size(); ++j) {
    EXPECT_GT(heights[j] - heights[j - 1], 0.45 * distance) << "layer " << j;
  }
  EXPECT_GT(world.nearest(), 0.85 * distance);
  EXPECT_LT(world.fastest(), 0.2);
}

// Shifted layers sink into each other's hollows, where each particle touches seven.
TEST_P(HeapOfCloth, OfShiftedLayersKeepsItsOrder) {
  Heap heap;
  heap.precision = GetParam();
  heap.shift = 0.4 * distance;
  heap.substeps = 40;
  HeapWorld world(heap);
  world.test.step(1.0 / 60, 60);
  const std::vector<double> heights = world.heights();
  for (size_t j = 1; j < heights.size(); ++j) {
    EXPECT_GT(heights[j] - heights[j - 1], 0.45 * distance) << "layer " << j;
  }
  EXPECT_GT(world.nearest(), 0.9 * distance);
}

INSTANTIATE_TEST_SUITE_P(Both, HeapOfCloth, both_precisions(), precision_name);

// The overlap that carries a heap is not to push apart what nothing presses together.
TEST(Heap, ThatOverlapsWithoutGravityPartsWithoutSpeed) {
  Heap heap;
  heap.layers = 2;
  heap.gap = 0.7 * distance;
  heap.gravity = 0;
  heap.lowest = 0.1;
  HeapWorld world(heap);
  world.test.step(1.0 / 60, 30);
  EXPECT_GT(world.nearest(), 0.999 * distance);
  EXPECT_LT(world.fastest(), 1e-4);
}

}  // namespace
}  // namespace weft_tests::heap
