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
  ASSERT_TRUE(is_inside(sphere, still, x));
  const auto out = way_out(sphere, still, x);
  EXPECT_NEAR(x.x + out.x, 1.5, 1e-15);
  EXPECT_EQ(out.y, 0);
  EXPECT_FALSE(is_inside(sphere, still, Vec3<double>{1.5, 2, 3}));
}
TEST(Colliders, TheCentreOfASphereLeavesAlongY) {
  const Sphere<float> sphere{{1, 1, 1}, 2, {}};
  const auto out = way_out(sphere, Vec3<float>{0, 0, 0}, Vec3<float>{1, 1, 1});
  EXPECT_EQ(out.x, 0);
  EXPECT_EQ(out.y, 2);
  EXPECT_EQ(out.z, 0);
}
TEST(Colliders, APlaneLiftsByTheDepth) {
  const double s = std::sqrt(0.5);
  const Plane<double> plane{{s, s, 0}, 2, {}};
  const auto out = way_out(plane, still, still);
  EXPECT_NEAR(out.x, 2 * s, 1e-15);
  EXPECT_NEAR(out.y, 2 * s, 1e-15);
  EXPECT_FALSE(is_inside(plane, still, Vec3<double>{5, 5, 0}));
}

TEST(ImpactShare, IsAllForWhatCameInAndNoneForWhatRestedInside) {
  const Vec3<double> push{0, 0.1, 0};
  EXPECT_EQ(impact_share(push, Vec3<double>{5, -0.1, 0}), 1);
  EXPECT_EQ(impact_share(push, Vec3<double>{0, -0.3, 0}), 1);
  EXPECT_NEAR(impact_share(push, Vec3<double>{0, -0.025, 0}), 0.5, 1e-15);  // bounces at most
  EXPECT_NEAR(impact_share(push, Vec3<double>{0, 0.2, 0}), 0, 1e-15);
  EXPECT_EQ(impact_share(push, still), 0);
  EXPECT_EQ(impact_share(still, Vec3<double>{1, 1, 1}), 0);
}

TEST(FrictionDisplacement, SticksInTheConeAndSlidesOnIt) {
  const Vec3<double> push{0, 0.1, 0};
  const auto stuck = friction_displacement(push, Vec3<double>{0.03, -0.1, 0.04}, 1.0, 0.5);
  EXPECT_DOUBLE_EQ(stuck.x, -0.03);
  EXPECT_EQ(stuck.y, 0);
  EXPECT_DOUBLE_EQ(stuck.z, -0.04);
  const auto sliding = friction_displacement(push, Vec3<double>{0.3, -0.1, 0.4}, 1.0, 0.5);
  EXPECT_NEAR(sliding.x, -0.03, 1e-16);
  EXPECT_NEAR(sliding.z, -0.04, 1e-16);
  EXPECT_EQ(friction_displacement(push, Vec3<double>{0.3, -0.1, 0.4}, 1.0, 0.0).x, 0);
}

}  // namespace weft
