#include "scene/trigonometry.h"

#include <cmath>

namespace weft::scene {

namespace {

/// Taylor polynomials on [-pi/4, pi/4], where the first term left out is below 2e-19.
SineCosine on_first_octants(double x) {
  const double z = x * x;
  double s = 0, c = 0;
  static constexpr double sine_terms[] = {
      1.0 / 355687428096000.0, -1.0 / 1307674368000.0, 1.0 / 6227020800.0, -1.0 / 39916800.0,
      1.0 / 362880.0,          -1.0 / 5040.0,          1.0 / 120.0,        -1.0 / 6.0};
  static constexpr double cosine_terms[] = {-1.0 / 6402373705728000.0,
                                            1.0 / 20922789888000.0,
                                            -1.0 / 87178291200.0,
                                            1.0 / 479001600.0,
                                            -1.0 / 3628800.0,
                                            1.0 / 40320.0,
                                            -1.0 / 720.0,
                                            1.0 / 24.0,
                                            -0.5};
  for (const double term : sine_terms) s = s * z + term;
  for (const double term : cosine_terms) c = c * z + term;
  return {x + x * (z * s), 1.0 + z * c};
}

SineCosine turn(SineCosine v, int quarters) {
  switch (quarters & 3) {
    case 1:
      return {v.cosine, -v.sine};
    case 2:
      return {-v.sine, -v.cosine};
    case 3:
      return {-v.cosine, v.sine};
    default:
      return v;
  }
}

}  // namespace

SineCosine sine_cosine(double radians) {
  // pi/2 in three parts of 33 bits, so that quarters * part is exact for |quarters| < 2^20.
  constexpr double part1 = 1.57079632673412561417e+00;
  constexpr double part2 = 6.07710050630396597660e-11;
  constexpr double part3 = 2.02226624879595063154e-21;
  const double quarters = std::nearbyint(radians * 6.36619772367581382433e-01);
  const double x = ((radians - quarters * part1) - quarters * part2) - quarters * part3;
  return turn(on_first_octants(x), static_cast<int>(static_cast<long long>(quarters) & 3));
}

SineCosine sine_cosine_degrees(double degrees) {
  const double within = std::fmod(degrees, 360.0);  // exact
  const double quarters = std::nearbyint(within / 90.0);
  return turn(on_first_octants((within - 90.0 * quarters) * 1.74532925199432954744e-02),
              static_cast<int>(quarters));
}

}  // namespace weft::scene
