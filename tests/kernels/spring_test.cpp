#include "kernels/spring.h"

#include <cmath>

#include <gtest/gtest.h>

namespace weft {
using namespace WEFT_BACKEND_NS;

TEST(SpringForce, PullsATooLongSpringTogetherAndPushesATooShortOneApart) {
  EXPECT_EQ(spring_force(Vec3<double>{1.5, 0, 0}, 100.0, 1.0).x, 50.0);
  EXPECT_EQ(spring_force(Vec3<double>{0.5, 0, 0}, 100.0, 1.0).x, -50.0);
}

TEST(SpringForce, NoLengthPullsNothing) {
  for (const double rest : {0.0, 0.1}) {
    const auto f = spring_force(Vec3<float>{0, 0, 0}, 100.0f, float(rest));
    EXPECT_EQ(f.x, 0);
    EXPECT_EQ(f.y, 0);
    EXPECT_EQ(f.z, 0);
  }
}

TEST(SpringForce, StaysBoundedWhereSquaresUnderflow) {
  for (float length = 1; length > 1e-38f; length /= 7) {
    const auto f = spring_force(Vec3<float>{length, 0, 0}, 200.0f, 0.1f);
    ASSERT_TRUE(std::isfinite(f.x)) << length;
    // Just above the underflow of the square, the length has lost digits.
    ASSERT_LE(std::abs(f.x), std::max(200.0f * 0.1f * 1.42f, 200.0f * length)) << length;
  }
}

TEST(SpringForce, IsAntisymmetricToTheLastBit) {
  const Vec3<float> to{0.1234567f, -0.7654321f, 0.3141592f};
  const auto f = spring_force(to, 123.4f, 0.5f);
  const auto g = spring_force(Vec3<float>{-to.x, -to.y, -to.z}, 123.4f, 0.5f);
  EXPECT_EQ(f.x, -g.x);
  EXPECT_EQ(f.y, -g.y);
  EXPECT_EQ(f.z, -g.z);
}

TEST(SpringDampingForce, ActsAlongTheSpringOnly) {
  const auto f = spring_damping_force(Vec3<double>{2, 0, 0}, Vec3<double>{3, 5, 7}, 0.5);
  EXPECT_DOUBLE_EQ(f.x, 1.5);
  EXPECT_EQ(f.y, 0);
  EXPECT_EQ(f.z, 0);
}

}  // namespace weft
