// Numbers of one call: they depend on the seed of the run and on the number of the call alone, so
// that a call stays what it is where others are left out.
#pragma once

#include "weft/core.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace weft_tests::driver {

/// SplitMix64 (Steele, Lea and Flood 2014).
class Random {
 public:
  Random(uint64_t seed, uint64_t call) : state_(seed * 0x9e3779b97f4a7c15ull) {
    state_ = next() + call * 0xd1342543de82ef95ull;
    next();
  }
  uint64_t next() {
    uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  /// 0 of none.
  uint32_t below(size_t count) {
    return count > 0 ? static_cast<uint32_t>((next() >> 33) % count) : 0;
  }
  uint32_t from_to(uint32_t low, uint32_t high) { return low + below(high - low + 1); }
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double real(double low, double high) { return low + (high - low) * unit(); }
  bool chance(double probability) { return unit() < probability; }
  template <class T, size_t count>
  T one_of(const T (&values)[count]) {
    return values[below(count)];
  }
  weft::double3 vector(double size) {
    return {real(-size, size), real(-size, size), real(-size, size)};
  }
  /// What no number of the interface may be.
  double bad() {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    constexpr double endless = std::numeric_limits<double>::infinity();
    const double values[] = {none, endless, -endless, 1e30, -1e300};
    return one_of(values);
  }
  /// What a number may be and seldom is.
  double extreme() {
    const double values[] = {0.0, 1e-300, 5e-324, 1e-30, 1e-18, 1e-12,  1e-6, 1.0,
                             1e4, 1e6,    1e9,    1e12,  1e18,  -1e-12, -1e6, -1e18};
    return one_of(values);
  }
  weft::double3 bad_vector() {
    weft::double3 v = vector(1);
    (below(3) == 0 ? v.x : below(2) == 0 ? v.y : v.z) = bad();
    return v;
  }

 private:
  uint64_t state_;
};

/// FNV-1a 64 over whatever is added.
class Digest {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>);
    add(&value, sizeof value);
  }
  void add(const weft::double3& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  void add(const void* bytes, size_t count) {
    const auto* p = static_cast<const unsigned char*>(bytes);
    for (size_t i = 0; i < count; ++i) hash_ = (hash_ ^ p[i]) * 0x100000001b3ull;
  }
  uint64_t value() const { return hash_; }

 private:
  uint64_t hash_ = 0xcbf29ce484222325ull;
};

}  // namespace weft_tests::driver
