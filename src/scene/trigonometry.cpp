#include "scene/trigonometry.h"

#include <cmath>
#include <cstdint>

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

__extension__ typedef unsigned __int128 Wide;

/// Of an angle of more than 2^20 quarters, which is m 2^e with an integer m: of m 2^e 2/pi, what is
/// below 4 quarters, from as many bits of 2/pi as that takes.
SineCosine of_many_turns(double radians) {
  static constexpr uint64_t two_over_pi[20] = {
      // 2^-64, 2^-128, ...
      0xa2f9836e4e441529ull, 0xfc2757d1f534ddc0ull, 0xdb6295993c439041ull, 0xfe5163abdebbc561ull,
      0xb7246e3a424dd2e0ull, 0x06492eea09d1921cull, 0xfe1deb1cb129a73eull, 0xe88235f52ebb4484ull,
      0xe99c7026b45f7e41ull, 0x3991d639835339f4ull, 0x9c845f8bbdf9283bull, 0x1ff897ffde05980full,
      0xef2f118b5a0a6d1full, 0x6d367ecf27cb09b7ull, 0x4f463f669e5fea2dull, 0x7527bac7ebe5f17bull,
      0x3d0739f78a5292eaull, 0x6bfb5fb11f8d5d08ull, 0x56033046fc7b6babull, 0xf0cfbc209af4361dull};
  int e = 0;
  const auto m = static_cast<uint64_t>(std::ldexp(std::frexp(std::fabs(radians), &e), 53));
  e -= 53;
  // Words before `first` give multiples of four quarters.
  const int first = e > 1 ? (e - 2) / 64 : 0;
  uint64_t product[5] = {};  // of m and four words, the lowest first
  for (int w = 0; w < 4; ++w) {
    const Wide part = Wide(m) * two_over_pi[first + 3 - w] + product[w];
    product[w] = static_cast<uint64_t>(part);
    product[w + 1] = static_cast<uint64_t>(part >> 64);
  }
  const int point = 64 * (first + 4) - e;  // bits below the point
  const auto bits_from = [&](int bit) {
    const int word = bit / 64, shift = bit % 64;
    const uint64_t high = word + 1 < 5 && shift > 0 ? product[word + 1] << (64 - shift) : 0;
    return product[word] >> shift | high;
  };
  auto quarters = static_cast<int>(bits_from(point) & 3);
  Wide fraction = Wide(bits_from(point - 64)) << 64 | bits_from(point - 128);
  const bool above = (fraction >> 127) != 0;
  if (above) {  // count back from the next quarter
    fraction = ~fraction + 1;
    ++quarters;
  }
  const double of_quarter = std::ldexp(static_cast<double>(fraction), -128);
  const double x = (above ? -of_quarter : of_quarter) * 1.57079632679489661923;
  const SineCosine found = turn(on_first_octants(x), quarters);
  return radians < 0 ? SineCosine{-found.sine, found.cosine} : found;
}

}  // namespace

SineCosine sine_cosine(double radians) {
  if (!std::isfinite(radians)) return {radians - radians, radians - radians};
  // pi/2 in three parts of 33 bits, so that quarters * part is exact for |quarters| < 2^20.
  constexpr double part1 = 1.57079632673412561417e+00;
  constexpr double part2 = 6.07710050630396597660e-11;
  constexpr double part3 = 2.02226624879595063154e-21;
  const double quarters = std::nearbyint(radians * 6.36619772367581382433e-01);
  if (std::fabs(quarters) > 1048576) return of_many_turns(radians);
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
