#include "kernels/colliders.h"

#include <cmath>

#include <gtest/gtest.h>

namespace weft {
using namespace WEFT_BACKEND_NS;

namespace {
constexpr Vec3<double> still{0, 0, 0};
}

TEST(Colliders, ASphereIsLeftAlongTheNormal) {
  const Sphere<double> sphere{{1, 2, 3}, 0.5, {}};
  const Vec3<double> x{1.1, 2, 3};
  ASSERT_TRUE(is_inside(sphere, x));
  const auto out = way_out(sphere, x);
  EXPECT_NEAR(x.x + out.depth * out.normal.x, 1.5, 1e-15);
  EXPECT_EQ(out.normal.y, 0);
  EXPECT_FALSE(is_inside(sphere, Vec3<double>{1.5, 2, 3}));
}
TEST(Colliders, TheCentreOfASphereLeavesAlongY) {
  const Sphere<float> sphere{{1, 1, 1}, 2, {}};
  const auto out = way_out(sphere, Vec3<float>{1, 1, 1});
  EXPECT_EQ(out.normal.x, 0);
  EXPECT_EQ(out.normal.y, 1);
  EXPECT_EQ(out.normal.z, 0);
  EXPECT_EQ(out.depth, 2);
}
TEST(Colliders, APlaneLiftsByTheDepth) {
  const double s = std::sqrt(0.5);
  const Plane<double> plane{{s, s, 0}, 2, {}};
  const auto out = way_out(plane, still);
  EXPECT_EQ(out.depth, 2);
  EXPECT_EQ(out.normal.x, s);
  EXPECT_EQ(out.normal.y, s);
  EXPECT_FALSE(is_inside(plane, Vec3<double>{5, 5, 0}));
}

TEST(StoppedDisplacement, IsWhatCameInAndNothingForWhatRestedInside) {
  EXPECT_EQ(stopped_displacement(0.1, -0.1), 0.1);
  EXPECT_EQ(stopped_displacement(0.1, -0.3), 0.1);
  EXPECT_EQ(stopped_displacement(0.1, -0.025), 0.025);  // stops, and does not bounce
  EXPECT_EQ(stopped_displacement(0.1, 0.2), 0);
  EXPECT_EQ(stopped_displacement(0.1, 0.0), 0);
}

TEST(PartHeld, IsAllInTheConeAndLessOutside) {
  EXPECT_EQ(part_held(Vec3<double>{0.03, 0, 0.04}, 0.05), 1);
  EXPECT_NEAR(part_held(Vec3<double>{0.3, 0, 0.4}, 0.05), 0.1, 1e-16);
  EXPECT_EQ(part_held(Vec3<double>{0.3, 0, 0.4}, 0.0), 0);
  EXPECT_EQ(part_held(Vec3<double>{0, 0, 0}, 0.0), 1);
}

}  // namespace weft
