// Where particles leave capsules, capped cylinders and boxes: exact signed distances (HC50).
#include "reference/networks.h"

#include <cmath>

namespace weft_tests {
namespace {

using Shapes = BothPrecisions;

/// Puts resting particles into a world with one collider and returns where one step leaves them.
template <class Create>
std::vector<Vec> after_one_step(weft::Precision precision, const std::vector<Vec>& start,
                                Create create) {
  TestWorld test(plain_world(precision));
  const weft::ClothId cloth = add_particles(test, start);
  create(test);
  test.step(0.01);
  std::vector<Vec> out;
  for (size_t i = 0; i < start.size(); ++i) out.push_back(test.position(cloth, uint32_t(i)));
  return out;
}

TEST_P(Shapes, ACappedCylinderIsLeftThroughTheNearestOfSideAndCaps) {
  const std::vector<Vec> start{{.1, 0, .2}, {0, 0, .9}, {.3, 0, .95}, {.6, 0, 1.1}, {0, .2, .4}};
  const std::vector<Vec> expected{{.5, 0, .2}, {0, 0, 1}, {.3, 0, 1}, {.6, 0, 1.1}, {0, .5, .4}};
  const auto x = after_one_step(GetParam(), start, [](TestWorld& test) {
    weft::CylinderDesc cylinder;
    cylinder.a = {0, 0, -1};
    cylinder.b = {0, 0, 1};
    cylinder.radius = 0.5;
    test.take(test.world().create_cylinder(cylinder));
  });
  for (size_t i = 0; i < x.size(); ++i) expect_near(x[i], expected[i], tolerance(GetParam(), 1));
}

TEST_P(Shapes, APointOnTheAxisLeavesAcrossIt) {
  const auto x = after_one_step(GetParam(), {{0, 0.5, 0}, {3, 0.5, 0}}, [](TestWorld& test) {
    weft::CylinderDesc cylinder;  // its caps are as far as its side: the side wins
    cylinder.radius = 0.5;
    test.take(test.world().create_cylinder(cylinder));
    weft::CapsuleDesc capsule;
    capsule.a = {3, 0, 0};
    capsule.b = {3, 1, 0};
    capsule.radius = 0.25;
    test.take(test.world().create_capsule(capsule));
  });
  EXPECT_NEAR(std::hypot(x[0].x, x[0].z), 0.5, 1e-6);
  EXPECT_NEAR(x[0].y, 0.5, 1e-6);
  EXPECT_NEAR(std::hypot(x[1].x - 3, x[1].z), 0.25, 1e-6);
  EXPECT_NEAR(x[1].y, 0.5, 1e-6);
}

TEST_P(Shapes, ACapsuleIsASphereAtItsEndsAndAPipeBetween) {
  const std::vector<Vec> start{{1, .1, 0}, {-.1, 0, 0}, {2.06, .08, 0}, {1, .6, 0}};
  const std::vector<Vec> expected{{1, .5, 0}, {-.5, 0, 0}, {2.3, .4, 0}, {1, .6, 0}};
  const auto x = after_one_step(GetParam(), start, [](TestWorld& test) {
    weft::CapsuleDesc capsule;
    capsule.b = {2, 0, 0};
    capsule.radius = 0.5;
    test.take(test.world().create_capsule(capsule));
  });
  for (size_t i = 0; i < x.size(); ++i) expect_near(x[i], expected[i], tolerance(GetParam(), 2));
}

TEST_P(Shapes, ACapsuleOfNoLengthIsASphere) {
  const auto x = after_one_step(GetParam(), {{0.3, 0, 0.4}, {0, 0, 0}}, [](TestWorld& test) {
    weft::CapsuleDesc capsule;
    capsule.b = capsule.a;
    test.take(test.world().create_capsule(capsule));
  });
  expect_near(x[0], {0.6, 0, 0.8}, tolerance(GetParam(), 1));
  EXPECT_NEAR(length(x[1]), 1, 1e-6);
}

TEST_P(Shapes, ATurnedBoxIsLeftThroughTheNearestFace) {
  const double s = std::sqrt(0.5);
  // Half edges 1 x 2 x 3, turned by 45 degrees about z: its first edge points along (s, s, 0).
  const auto world = [&](Vec in_box) {
    return Vec{5 + s * (in_box.x - in_box.y), 1 + s * (in_box.x + in_box.y), in_box.z};
  };
  const std::vector<Vec> inside{
      {.8, .5, .5}, {-.9, 0, 0}, {.2, -1.9, 1}, {.3, .4, 2.95}, {1.2, 0, 0}};
  const std::vector<Vec> left{{1, .5, .5}, {-1, 0, 0}, {.2, -2, 1}, {.3, .4, 3}, {1.2, 0, 0}};
  std::vector<Vec> start;
  for (const Vec& p : inside) start.push_back(world(p));
  const auto x = after_one_step(GetParam(), start, [](TestWorld& test) {
    weft::BoxDesc box;
    box.center = {5, 1, 0};
    box.half = {1, 2, 3};
    box.axis = {0, 0, 2};
    box.degrees = 45;
    test.take(test.world().create_box(box));
  });
  for (size_t i = 0; i < x.size(); ++i) expect_near(x[i], world(left[i]), tolerance(GetParam(), 4));
}

TEST_P(Shapes, ShapesThatMovePushWhatTheyReach) {
  weft::BoxDesc box;  // its upper face passes y = 0.25 after a quarter of a second
  box.center = {0, -1, 0};
  box.velocity = {0, 1, 0};
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = add_particles(test, {{0.1, 0.25, 0}});
  test.take(test.world().create_box(box));
  for (int n = 1; n <= 100; ++n) {
    test.step(0.01);
    const double face = 0.01 * n;
    ASSERT_NEAR(test.position(cloth, 0).y, std::max(0.25, face), tolerance(GetParam(), 1)) << n;
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, Shapes, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
