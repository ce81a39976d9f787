// Lines of the debug view lie on what they show.
#include <cmath>

#include "reference/world_helpers.h"

namespace weft_tests {
namespace {

struct Line {
  Vec a, b;
  uint32_t colour;
};

std::vector<Line> lines_of(TestWorld& test, uint32_t what) {
  std::vector<Line> lines;
  weft::DebugDraw draw;
  draw.user = &lines;
  draw.what = what;
  draw.line = [](void* user, weft::double3 a, weft::double3 b, uint32_t rgba) {
    static_cast<std::vector<Line>*>(user)->push_back({from_weft(a), from_weft(b), rgba});
  };
  test.check(test.world().debug_draw(draw));
  return lines;
}
double size(Vec v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

TEST(DebugView, ShowsEverySpringInTheColourOfItsStrain) {
  weft::WorldDesc desc;
  desc.gravity = {0, 0, 0};
  TestWorld test(desc);
  weft::GridDesc grid;
  grid.rows = grid.columns = 3;
  grid.stencil = weft::Stencil::quad4;
  std::vector<weft::double3> x;
  for (int v = 0; v < 9; ++v) x.push_back({v % 3 * 0.55, v / 3 * 0.48, 0});  // +10 %, -4 %
  weft::ClothDesc cloth;
  cloth.positions = weft::View<weft::double3>(x);
  const weft::Pin pins[] = {{4}};
  cloth.pins = {pins, 1};
  test.add(grid, cloth);
  const std::vector<Line> springs = lines_of(test, weft::DebugDraw::springs);
  ASSERT_EQ(springs.size(), 12u);
  int red = 0, bluish = 0;
  for (const Line& l : springs) {
    const Vec d = l.b - l.a;
    if (std::abs(d.x) > 0.5) {
      red += l.colour == 0xff0000ffu;
    } else {
      bluish += l.colour == 0x9999ffffu;
    }
  }
  EXPECT_EQ(red, 6);
  EXPECT_EQ(bluish, 6);
  const std::vector<Line> crosses = lines_of(test, weft::DebugDraw::pins);
  ASSERT_EQ(crosses.size(), 3u);
  for (const Line& l : crosses) EXPECT_NEAR(size(0.5 * (l.a + l.b) - Vec{0.55, 0.48, 0}), 0, 1e-6);
  const std::vector<Line> box = lines_of(test, weft::DebugDraw::bounds);
  EXPECT_EQ(box.size(), 12u);
}

TEST(DebugView, CollidersAreDrawnWhereTheyAre) {
  TestWorld test;
  weft::SphereDesc sphere;
  sphere.center = {1, 2, 3};
  sphere.radius = 0.5;
  const weft::ColliderId ball = test.take(test.world().create_sphere(sphere));
  weft::Pose pose;
  pose.translate = {0, 1, 0};
  test.check(test.world().move_collider(ball, pose, weft::Move::teleport));
  for (const Line& l : lines_of(test, weft::DebugDraw::all))
    EXPECT_NEAR(size(l.a - Vec{1, 3, 3}), 0.5, 1e-12);
  test.check(test.world().destroy_collider(ball));

  weft::BoxDesc box;
  box.half = {0.1, 0.2, 0.3};
  test.take(test.world().create_box(box));
  double sum = 0;
  for (const Line& l : lines_of(test, weft::DebugDraw::colliders)) {
    EXPECT_NEAR(size(l.a), std::sqrt(0.14), 1e-12);
    sum += size(l.b - l.a);
  }
  EXPECT_NEAR(sum, 4 * (0.2 + 0.4 + 0.6), 1e-12);
  weft::CapsuleDesc capsule;
  weft::CylinderDesc cylinder;
  test.take(test.world().create_capsule(capsule));
  test.take(test.world().create_cylinder(cylinder));
  test.take(test.world().create_plane({}));
  EXPECT_GT(lines_of(test, weft::DebugDraw::colliders).size(), 150u);
  EXPECT_TRUE(lines_of(test, weft::DebugDraw::springs).empty());
}

TEST(DebugView, NeedsSomewhereToDraw) {
  TestWorld test;
  EXPECT_EQ(test.world().debug_draw({}), weft::Status::invalid_argument);
  weft::DebugDraw draw;
  draw.line = [](void*, weft::double3, weft::double3, uint32_t) {};
  draw.full_strain = 0;
  EXPECT_EQ(test.world().debug_draw(draw), weft::Status::invalid_argument);
}

}  // namespace
}  // namespace weft_tests
