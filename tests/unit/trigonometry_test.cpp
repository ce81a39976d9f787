#include "scene/trigonometry.h"

#include <cmath>
#include <limits>

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

TEST(Trigonometry, IsExactAtAnyAngle) {
  // Sines and cosines of these doubles from 3000 bits of pi.
  const struct {
    double angle, sine, cosine;
  } known[] = {{1700000.0, 0.5711113510481804, -0.8208725995572772},
               {1000000000.0, 0.5458434494486996, 0.8378871813639024},
               {1000000000000000.0, 0.8582727931702359, -0.5131937377869703},
               {1e+18, -0.9929693207404051, 0.11837199021871073},
               {9007199254740992.0, -0.848925964814655, -0.5285117844130887},
               {1e+22, -0.8522008497671888, 0.523214785395139},
               {1e+100, -0.3806377310050287, 0.9247242387519338},
               {1.7976931348623157e+308, 0.004961954789184062, -0.9999876894265599},
               {5.319372648326541e+255, 1.0, -4.687165924254628e-19}};
  for (const auto& k : known) {
    EXPECT_NEAR(sine_cosine(k.angle).sine, k.sine, 3e-16) << k.angle;
    EXPECT_NEAR(sine_cosine(k.angle).cosine, k.cosine, 3e-16) << k.angle;
    EXPECT_NEAR(sine_cosine(-k.angle).sine, -k.sine, 3e-16) << k.angle;
    EXPECT_NEAR(sine_cosine(-k.angle).cosine, k.cosine, 3e-16) << k.angle;
  }
  for (double x = 1e6; x < 1e300; x *= 3.7) {
    const auto [s, c] = sine_cosine(x);
    ASSERT_NEAR(s * s + c * c, 1, 1e-15) << x;
    ASSERT_NEAR(s, std::sin(x), 3e-16) << x;
  }
  EXPECT_TRUE(std::isnan(sine_cosine(std::numeric_limits<double>::infinity()).sine));
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
