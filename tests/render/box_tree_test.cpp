// Against a look at every box.
#include "render/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace weft::render;

namespace {

class Boxes {
 public:
  explicit Boxes(uint32_t seed) : random_(seed) {}
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Vector3d point() { return {number(), number(), number()}; }
  Box around(double size) {
    Box box;
    const Vector3d at = point();
    box.add(at);
    box.add(at + size * point());
    return box;
  }

 private:
  std::mt19937 random_;
};

bool touch(const Box& a, const Box& b) { return !a.within(b).empty(); }

std::vector<uint32_t> near_in(const BoxTree& tree, const Box& box) {
  std::vector<uint32_t> found;
  tree.each_near(box, [&](uint32_t i) { found.push_back(i); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<uint32_t> near_among(const std::vector<Box>& boxes, const Box& box) {
  std::vector<uint32_t> found;
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    if (touch(boxes[i], box)) found.push_back(i);
  }
  return found;
}

}  // namespace

TEST(BoxTree, FindsEachBoxThatTouchesOnce) {
  Boxes random(7);
  for (const size_t count : {0u, 1u, 4u, 5u, 37u, 1000u}) {
    std::vector<Box> boxes;
    for (size_t i = 0; i < count; ++i) boxes.push_back(random.around(i % 3 == 0 ? 1.5 : 0.05));
    const BoxTree tree(boxes);
    size_t found = 0;
    for (int k = 0; k < 200; ++k) {
      const Box box = random.around(0.3);
      const auto want = near_among(boxes, box);
      EXPECT_EQ(near_in(tree, box), want);
      found += want.size();
    }
    EXPECT_EQ(found > 0, count > 0);
  }
}

// A grid of cells would hold each of them in every cell: 4 billion times.
TEST(BoxTree, HoldsManyBoxesThatReachFar) {
  Boxes random(8);
  std::vector<Box> boxes(17000, Box{Vector3d::Constant(-1), Vector3d::Constant(1)});
  for (Box& box : boxes) box = box.grown(0.1 * random.number());
  const BoxTree tree(boxes);
  EXPECT_EQ(near_in(tree, {Vector3d::Zero(), Vector3d::Constant(0.1)}).size(), boxes.size());
  EXPECT_TRUE(near_in(tree, {Vector3d::Constant(1.2), Vector3d::Constant(2)}).empty());
}

TEST(BoxTree, EndsWhereAllIsInOnePlace) {
  const std::vector<Box> boxes(1000, Box{Vector3d::Zero(), Vector3d::Zero()});
  EXPECT_EQ(near_in(BoxTree(boxes), boxes[0]).size(), boxes.size());
}
