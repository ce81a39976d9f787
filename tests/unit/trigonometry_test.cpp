#include "scene/trigonometry.h"

#include <cmath>

#include <gtest/gtest.h>

namespace weft::scene {

TEST(Trigonometry, AgreesWithTheCLibraryToRounding) {
  for (int i = -200000; i <= 200000; ++i) {
    const double x = i * 0.0371;
    const auto [s, c] = sine_cosine(x);
    ASSERT_NEAR(s, std::sin(x), 3e-16) << x;
    ASSERT_NEAR(c, std::cos(x), 3e-16) << x;
  }
}

TEST(Trigonometry, KeepsItsPrecisionFarFromZero) {
  for (const double x : {1e4, 12345.678, 1e5 + 0.5, 9.9e5, -7.7e5}) {
    EXPECT_NEAR(sine_cosine(x).sine, std::sin(x), 1e-15) << x;
    EXPECT_NEAR(sine_cosine(x).cosine, std::cos(x), 1e-15) << x;
  }
}

TEST(Trigonometry, QuarterTurnsAreExact) {
  const double sines[] = {0, 1, 0, -1}, cosines[] = {1, 0, -1, 0};
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const auto [s, c] = sine_cosine_degrees(90.0 * quarter);
    EXPECT_EQ(s, sines[quarter & 3]) << quarter;
    EXPECT_EQ(c, cosines[quarter & 3]) << quarter;
  }
  EXPECT_EQ(sine_cosine(0).sine, 0.0);
  EXPECT_NEAR(sine_cosine_degrees(30).sine, 0.5, 1e-16);
}

}  // namespace weft::scene
