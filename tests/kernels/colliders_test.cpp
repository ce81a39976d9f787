#include "kernels/colliders.h"

#include <cmath>

#include <gtest/gtest.h>

namespace weft {
using namespace WEFT_BACKEND_NS;

TEST(OutOfSphere, GoesToTheSurfaceAlongTheNormal) {
  const Vec3<double> c{1, 2, 3}, x{1.1, 2, 3};
  const auto by = out_of_sphere(x, c, 0.5);
  EXPECT_NEAR(x.x + by.x, 1.5, 1e-15);
  EXPECT_EQ(by.y, 0);
}
TEST(OutOfSphere, LeavesTheOutsideAloneToTheLastBit) {
  const auto by = out_of_sphere(Vec3<float>{3, 0, 0}, Vec3<float>{0, 0, 0}, 2.0f);
  EXPECT_EQ(by.x, 0);
  EXPECT_EQ(by.y, 0);
  EXPECT_EQ(by.z, 0);
}
TEST(OutOfSphere, TheCentreLeavesAlongY) {
  const auto by = out_of_sphere(Vec3<float>{1, 1, 1}, Vec3<float>{1, 1, 1}, 2.0f);
  EXPECT_EQ(by.x, 0);
  EXPECT_EQ(by.y, 2);
  EXPECT_EQ(by.z, 0);
}
TEST(OutOfPlane, LiftsByTheDepth) {
  const double s = std::sqrt(0.5);
  const auto by = out_of_plane(Vec3<double>{0, 0, 0}, Vec3<double>{s, s, 0}, 2.0);
  EXPECT_NEAR(by.x, 2 * s, 1e-15);
  EXPECT_NEAR(by.y, 2 * s, 1e-15);
  const auto none = out_of_plane(Vec3<double>{5, 5, 0}, Vec3<double>{s, s, 0}, 2.0);
  EXPECT_EQ(none.x, 0);
}

}  // namespace weft
