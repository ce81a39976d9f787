// Where triangles cross, against rational arithmetic on whole coordinates.
#include "io/crossings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "io/orientation.h"
#include "reference/random.h"

namespace weft::io {
namespace {

using Index = std::array<uint32_t, 3>;
using Pairs = std::vector<std::array<uint32_t, 2>>;
using Whole = std::array<int64_t, 3>;

Whole operator-(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Whole cross_product(const Whole& a, const Whole& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
int64_t dot(const Whole& a, const Whole& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

__extension__ typedef __int128 Int128;

struct Fraction {
  Int128 over, under;  ///< under > 0
  bool operator<(const Fraction& other) const { return over * other.under < other.over * under; }
};

/// The part of the line that both planes have in common which lies in a triangle; heights above the
/// other's plane on both sides of it.
std::array<Fraction, 2> part_on_line(const std::array<Whole, 3>& t,
                                     const std::array<int64_t, 3>& height, const Whole& line) {
  std::vector<Fraction> ends;
  for (size_t k = 0; k < 3; ++k) {
    const size_t next = (k + 1) % 3;
    if (height[k] == 0) ends.push_back({dot(line, t[k]), 1});
    if ((height[k] < 0) == (height[next] < 0) || height[k] == 0 || height[next] == 0) continue;
    const int64_t under = std::abs(height[k]) + std::abs(height[next]);
    ends.push_back({Int128(dot(line, t[k])) * std::abs(height[next]) +
                        Int128(dot(line, t[next])) * std::abs(height[k]),
                    under});
  }
  return {*std::min_element(ends.begin(), ends.end()), *std::max_element(ends.begin(), ends.end())};
}

bool on_both_sides(const std::array<int64_t, 3>& height) {
  return *std::min_element(height.begin(), height.end()) < 0 &&
         *std::max_element(height.begin(), height.end()) > 0;
}

bool cross_in_whole_numbers(const std::array<Whole, 3>& s, const std::array<Whole, 3>& t) {
  const Whole of_s = cross_product(s[1] - s[0], s[2] - s[0]);
  const Whole of_t = cross_product(t[1] - t[0], t[2] - t[0]);
  std::array<int64_t, 3> heights_s{}, heights_t{};
  for (size_t k = 0; k < 3; ++k) heights_s[k] = dot(of_t, s[k] - t[0]);
  if (!on_both_sides(heights_s)) return false;
  for (size_t k = 0; k < 3; ++k) heights_t[k] = dot(of_s, t[k] - s[0]);
  if (!on_both_sides(heights_t)) return false;
  const Whole line = cross_product(of_s, of_t);
  const auto part_s = part_on_line(s, heights_s, line), part_t = part_on_line(t, heights_t, line);
  return part_s[0] < part_t[1] && part_t[0] < part_s[1];
}

struct Triangles {
  std::vector<Whole> whole;
  std::vector<Index> triangles;

  void add(const std::array<Whole, 3>& corners) {
    const auto first = static_cast<uint32_t>(whole.size());
    whole.insert(whole.end(), corners.begin(), corners.end());
    triangles.push_back({first, first + 1, first + 2});
  }
  std::array<Whole, 3> corners(size_t t) const {
    return {whole[triangles[t][0]], whole[triangles[t][1]], whole[triangles[t][2]]};
  }
  std::vector<double3> positions(double scale = 1, double shift = 0) const {
    std::vector<double3> out;
    for (const Whole& v : whole) {
      out.push_back({double(v[0]) * scale + shift, double(v[1]) * scale - shift,
                     double(v[2]) * scale + 2 * shift});
    }
    return out;
  }
  bool share(size_t i, size_t j) const {
    for (const uint32_t v : triangles[i]) {
      if (std::count(triangles[j].begin(), triangles[j].end(), v) > 0) return true;
    }
    return false;
  }
  Pairs by_brute_force() const {
    Pairs found;
    for (uint32_t i = 0; i < triangles.size(); ++i) {
      for (uint32_t j = i + 1; j < triangles.size(); ++j) {
        if (!share(i, j) && cross_in_whole_numbers(corners(i), corners(j))) found.push_back({i, j});
      }
    }
    return found;
  }
};

Triangles two(const std::array<Whole, 3>& s, const std::array<Whole, 3>& t) {
  Triangles both;
  both.add(s);
  both.add(t);
  return both;
}

size_t count_of(const Triangles& all) { return crossings(all.positions(), all.triangles).size(); }

constexpr std::array<Whole, 3> flat{{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}}};

TEST(Crossings, NamesTwoTrianglesThatCross) {
  const Triangles all = two(flat, {{{1, 1, -1}, {2, 2, 5}, {3, 1, 5}}});
  EXPECT_EQ(crossings(all.positions(), all.triangles), (Pairs{{0, 1}}));
}

TEST(Crossings, DoNotCountWhatOnlyTouches) {
  EXPECT_EQ(count_of(two(flat, {{{1, 1, 0}, {2, 2, 5}, {3, 1, 5}}})), 0u) << "a corner on a face";
  EXPECT_EQ(count_of(two(flat, {{{1, 1, 0}, {3, 1, 0}, {2, 1, 5}}})), 0u) << "an edge on a face";
  EXPECT_EQ(count_of(two(flat, {{{3, -1, -3}, {3, 1, 3}, {3, -9, 0}}})), 0u) << "edge on edge";
  EXPECT_EQ(count_of(two(flat, {{{6, 0, 0}, {9, 0, 4}, {9, 0, -4}}})), 0u) << "corner on corner";
  EXPECT_EQ(count_of(two(flat, {{{1, 1, 1}, {2, 2, 5}, {3, 1, 5}}})), 0u) << "above";
  EXPECT_EQ(count_of(two(flat, {{{9, 9, -1}, {9, 8, 5}, {8, 9, 5}}})), 0u) << "beside";
}

TEST(Crossings, DoNotCountOnePlaneOrALine) {
  EXPECT_EQ(count_of(two(flat, flat)), 0u);
  EXPECT_EQ(count_of(two(flat, {{{1, 1, 0}, {9, 1, 0}, {1, 9, 0}}})), 0u);
  EXPECT_EQ(count_of(two(flat, {{{1, 1, -3}, {1, 1, 0}, {1, 1, 3}}})), 0u);
}

TEST(Crossings, CountAnEdgeThatGoesThroughAnEdge) {
  // The second goes on to either side of the first's edge x = 0, and into its inside.
  EXPECT_EQ(count_of(two(flat, {{{0, 2, -3}, {0, 2, 3}, {4, 2, 0}}})), 1u);
}

TEST(Crossings, LeaveOutTrianglesThatShareAVertex) {
  Triangles all = two(flat, {{{1, 1, -1}, {2, 2, 5}, {3, 1, 5}}});
  all.triangles[1][1] = 0;
  EXPECT_EQ(count_of(all), 0u);
}

TEST(Crossings, LeaveOutWhatIsNotFinite) {
  const Triangles all = two(flat, {{{1, 1, -1}, {2, 2, 5}, {3, 1, 5}}});
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::vector<double3> positions = all.positions();
    positions[4].y = value;
    EXPECT_TRUE(crossings(positions, all.triangles).empty());
  }
  EXPECT_TRUE(crossings({}, {}).empty());
}

TEST(Crossings, AreThoseOfBruteForceAmongTenThousandTriangles) {
  reference::SplitMix random(7);
  const auto within = [&](int64_t half) {
    return static_cast<int64_t>(random.bits() % uint64_t(2 * half + 1)) - half;
  };
  Triangles all;
  for (int t = 0; t < 10000; ++t) {
    const Whole at{within(500), within(500), within(300)};
    std::array<Whole, 3> corners{};
    for (Whole& corner : corners) {
      for (size_t k = 0; k < 3; ++k) corner[k] = at[k] + within(30);
    }
    all.add(corners);
  }
  const Pairs expected = all.by_brute_force();
  EXPECT_GT(expected.size(), 500u);
  EXPECT_EQ(crossings(all.positions(), all.triangles), expected);
}

// Few whole coordinates: most pairs have corners on planes, edges on edges, or one plane.
TEST(Crossings, AreThoseOfBruteForceWhereMostIsDegenerate) {
  reference::SplitMix random(11);
  Triangles all;
  for (int t = 0; t < 1500; ++t) {
    std::array<Whole, 3> corners{};
    for (Whole& corner : corners) {
      for (int64_t& x : corner) x = static_cast<int64_t>(random.bits() % 4);
    }
    all.add(corners);
  }
  const Pairs expected = all.by_brute_force();
  EXPECT_GT(expected.size(), 1000u);
  EXPECT_EQ(crossings(all.positions(), all.triangles), expected);
  // The same a thousand kilometres away in steps of a nanometre, which doubles hold exactly.
  EXPECT_EQ(crossings(all.positions(0x1p-30, 0x1p20), all.triangles), expected);
}

/// A sheet of n x n vertices folded in half along y, the upper half `gap` above the lower one;
/// distances in hundredths.
Triangles folded_sheet(int64_t n, int64_t gap) {
  Triangles sheet;
  for (int64_t r = 0; r < n; ++r) {
    for (int64_t c = 0; c < n; ++c) {
      const bool upper = c >= n / 2;
      // Shifted a little, so that nothing lies exactly above itself.
      const int64_t x = upper ? 100 * (n - 1 - c) + 37 : 100 * c;
      sheet.whole.push_back({x, 100 * r + (upper ? 13 : 0), upper ? gap + (r + c) % 3 : 0});
    }
  }
  for (uint32_t r = 0; r + 1 < n; ++r) {
    for (uint32_t c = 0; c + 1 < n; ++c) {
      const auto i = static_cast<uint32_t>(r * n + c), below = static_cast<uint32_t>(i + n);
      sheet.triangles.push_back({i, i + 1, below + 1});
      sheet.triangles.push_back({i, below + 1, below});
    }
  }
  return sheet;
}

TEST(Crossings, OfAFoldedSheetAreNoneUntilTheLayersPass) {
  EXPECT_EQ(count_of(folded_sheet(40, 5)), 0u);
  const Triangles passed = folded_sheet(40, -1);  // between -1 and 1: the layers interlace
  const Pairs expected = passed.by_brute_force();
  EXPECT_GT(expected.size(), 100u);
  EXPECT_EQ(crossings(passed.positions(), passed.triangles), expected);
}

TEST(Orientation, HasTheSignOfTheExactDeterminant) {
  reference::SplitMix random(3);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    // Corners of a slim tetrahedron far away; the last close to the plane of the others.
    std::array<Whole, 4> p{};
    for (Whole& v : p) {
      for (int64_t& x : v) x = static_cast<int64_t>(random.bits() % 2001) - 1000;
    }
    const auto weight = static_cast<int64_t>(random.bits() % 3);
    for (size_t k = 0; k < 3; ++k) {
      p[3][k] = p[0][k] + weight * (p[1][k] - p[0][k]) + (1 - weight) * (p[2][k] - p[0][k]);
    }
    p[3][2] += static_cast<int64_t>(random.bits() % 3) - 1;
    const int64_t exact = dot(p[0] - p[3], cross_product(p[1] - p[3], p[2] - p[3]));
    const int expected = exact > 0 ? 1 : exact < 0 ? -1 : 0;
    zeros += expected == 0;
    const auto far = [&](const Whole& v) {
      return double3{0x1p30 + double(v[0]) * 0x1p-22, double(v[1]) * 0x1p-22 - 0x1p28,
                     double(v[2]) * 0x1p-22};
    };
    ASSERT_EQ(orientation(far(p[0]), far(p[1]), far(p[2]), far(p[3])), expected) << i;
  }
  EXPECT_GT(zeros, 1000);
}

}  // namespace
}  // namespace weft::io
