// A point in double precision for the reference code of the tests; nothing here comes from weft.
#pragma once

#include <cmath>

namespace reference {

struct Vec {
  double x = 0, y = 0, z = 0;
};

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vec& operator+=(Vec& a, Vec b) { return a = a + b; }
inline Vec& operator-=(Vec& a, Vec b) { return a = a - b; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(Vec a) { return std::sqrt(dot(a, a)); }
inline bool finite(Vec a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// As float holds it. Through memory: g++ 12 drops the round trip of two neighbouring numbers.
inline double through_float(double v) {
  const volatile float narrow = float(v);
  return double(narrow);
}
inline Vec through_float(Vec v) {
  return {through_float(v.x), through_float(v.y), through_float(v.z)};
}

}  // namespace reference
