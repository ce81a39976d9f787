// Numbers of few digits against their definition: the nearest multiple of a power of two.
#include "kernels/measured/numbers.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "kernels/measured/sums.h"
#include "reference/random.h"

namespace weft {
using namespace WEFT_BACKEND_NS::measured;

namespace {

/// `digits` significant bits, but no step finer than 2^least.
double nearest(double v, int digits, int least) {
  if (v == 0) return 0;
  const double step = std::ldexp(1.0, std::max(std::ilogb(v) + 1 - digits, least));
  return std::nearbyint(v / step) * step;
}

template <class T>
class LowPrecision : public ::testing::Test {
 protected:
  /// Values of all sizes that a float holds exactly.
  template <class Check>
  void for_many(double smallest, double largest, Check check) {
    reference::SplitMix random(6);
    for (int i = 0; i < 200000; ++i) {
      const double size = smallest * std::pow(largest / smallest, random.uniform());
      const auto v = static_cast<float>(random.uniform() < 0.5 ? -size : size);
      check(static_cast<T>(v));
    }
  }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(LowPrecision, Scalars);

TYPED_TEST(LowPrecision, Float24HasSeventeenDigits) {
  this->for_many(1e-20, 1e20, [](TypeParam v) {
    ASSERT_EQ(rounded<float24_digits>(v), TypeParam(nearest(double(v), 17, -1000))) << v;
  });
  for (const double exact : {0.0, 1.0, -1.5, 131071.0, 1.0 + 1.0 / 65536}) {
    EXPECT_EQ(rounded<float24_digits>(TypeParam(exact)), TypeParam(exact));
  }
}

TYPED_TEST(LowPrecision, HalfIsThatOfIeee754) {
  this->for_many(1e-9, 65519, [](TypeParam v) {
    ASSERT_EQ(rounded_to_half(v), TypeParam(nearest(double(v), 11, -24))) << v;
  });
  EXPECT_EQ(rounded_to_half(TypeParam(65504)), TypeParam(65504));
  const auto infinity = std::numeric_limits<TypeParam>::infinity();
  EXPECT_EQ(rounded_to_half(TypeParam(65520)), infinity);
  EXPECT_EQ(rounded_to_half(TypeParam(-1e30)), -infinity);
  EXPECT_EQ(rounded_to_half(TypeParam(2.9e-8)), TypeParam(0));
  EXPECT_EQ(rounded_to_half(TypeParam(3.1e-8)), TypeParam(0x1p-24));
}

TYPED_TEST(LowPrecision, EveryOperationOfFloat24Rounds) {
  using F = Float24<TypeParam>;
  const F a(TypeParam(1)), b(TypeParam(0x1p-17));
  EXPECT_EQ((a + b).value, TypeParam(1));
  EXPECT_EQ((F(TypeParam(1)) / F(TypeParam(3))).value, TypeParam(nearest(1.0 / 3, 17, -1000)));
  EXPECT_EQ(square_root(F(TypeParam(2))).value, TypeParam(nearest(std::sqrt(2.0), 17, -1000)));
}

TYPED_TEST(LowPrecision, Fixed8StepsAndSaturates) {
  const Fixed8Sum<TypeParam> sum{TypeParam(127) / TypeParam(2), TypeParam(2) / TypeParam(127)};
  EXPECT_EQ(sum.term(TypeParam(2)), TypeParam(127));
  EXPECT_EQ(sum.term(TypeParam(5)), TypeParam(127));
  EXPECT_EQ(sum.term(TypeParam(-5)), TypeParam(-127));
  EXPECT_EQ(sum.term(TypeParam(0.007)), TypeParam(0));
  EXPECT_EQ(sum.term(TypeParam(0.009)), TypeParam(1));
  EXPECT_EQ(sum.sum(TypeParam(100), TypeParam(100)), TypeParam(127));
  EXPECT_EQ(sum.sum(TypeParam(-100), TypeParam(-100)), TypeParam(-127));
  EXPECT_NEAR(sum.result(TypeParam(127)), 2, 1e-6);
}

}  // namespace
}  // namespace weft
