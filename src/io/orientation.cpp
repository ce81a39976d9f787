#include "io/orientation.h"

#include <cmath>
#include <initializer_list>

namespace weft::io {
namespace {

/// A number as a sum of doubles that do not overlap, least first (Shewchuk, "Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates", 1997).
class Sum {
 public:
  /// Grow-expansion, without the zeros: exact.
  void add(double value) {
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      const double sum = value + terms_[i], part = sum - value;
      const double rest = (value - (sum - part)) + (terms_[i] - part);
      if (rest != 0) terms_[kept++] = rest;
      value = sum;
    }
    if (value != 0) terms_[kept++] = value;
    count_ = kept;
  }
  int sign() const { return count_ == 0 ? 0 : terms_[count_ - 1] > 0 ? 1 : -1; }

 private:
  double terms_[192];
  int count_ = 0;
};

/// high + low = x - y exactly.
struct Difference {
  double high, low;
  Difference(double x, double y) : high(x - y) {
    const double part = x - high;
    low = (x - (high + part)) + (part - y);
  }
};

void add_product(double x, double y, double z, Sum& sum) {
  const double high = x * y, low = std::fma(x, y, -high);
  const double highest = high * z, middle = low * z;
  sum.add(std::fma(low, z, -middle));
  sum.add(middle);
  sum.add(std::fma(high, z, -highest));
  sum.add(highest);
}

void add_product(const Difference& x, const Difference& y, const Difference& z, double sign,
                 Sum& sum) {
  for (const double u : {x.low, x.high}) {
    for (const double v : {y.low, y.high}) {
      for (const double w : {z.low, z.high}) {
        if (u != 0 && v != 0 && w != 0) add_product(sign * u, v, w, sum);
      }
    }
  }
}

int exact_orientation(const double3& a, const double3& b, const double3& c, const double3& d) {
  const Difference ax(a.x, d.x), ay(a.y, d.y), az(a.z, d.z);
  const Difference bx(b.x, d.x), by(b.y, d.y), bz(b.z, d.z);
  const Difference cx(c.x, d.x), cy(c.y, d.y), cz(c.z, d.z);
  Sum sum;
  add_product(ax, by, cz, 1, sum);
  add_product(ax, bz, cy, -1, sum);
  add_product(ay, bz, cx, 1, sum);
  add_product(ay, bx, cz, -1, sum);
  add_product(az, bx, cy, 1, sum);
  add_product(az, by, cx, -1, sum);
  return sum.sign();
}

}  // namespace

int orientation(const double3& a, const double3& b, const double3& c, const double3& d) {
  const double ax = a.x - d.x, ay = a.y - d.y, az = a.z - d.z;
  const double bx = b.x - d.x, by = b.y - d.y, bz = b.z - d.z;
  const double cx = c.x - d.x, cy = c.y - d.y, cz = c.z - d.z;
  const double determinant =
      ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  const double size = std::fabs(ax) * (std::fabs(by * cz) + std::fabs(bz * cy)) +
                      std::fabs(ay) * (std::fabs(bz * cx) + std::fabs(bx * cz)) +
                      std::fabs(az) * (std::fabs(bx * cy) + std::fabs(by * cx));
  // Shewchuk's bound is (7 + 56 u) u of the size, u = 2^-53.
  const double error = 8 * 0x1p-53 * size;
  if (determinant > error) return 1;
  if (determinant < -error) return -1;
  if (size == 0) return 0;
  return exact_orientation(a, b, c, d);
}

}  // namespace weft::io
