// Cutting polygons: the triangles cover what the outline goes round, once, from any first corner.
#include "io/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <random>

namespace weft::io::test::polygon {
namespace {

using Points = std::vector<double3>;
constexpr double pi = 3.14159265358979323846;

Polygon in_order(size_t n) {
  Polygon polygon(n);
  std::iota(polygon.begin(), polygon.end(), 0u);
  return polygon;
}

struct CutPolygon {
  Cut cut;
  std::vector<uint32_t> triangles;
};

CutPolygon cut(const Points& points, const Polygon& polygon) {
  MemoryLimit memory(uint64_t(1) << 30, 0);
  PolygonCutter cutter(memory);
  CutPolygon result{Cut::done, std::vector<uint32_t>(3 * (polygon.size() - 2))};
  result.cut = cutter.cut(points, polygon, result.triangles.data());
  return result;
}

double3 minus(double3 a, double3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double3 cross(double3 a, double3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(double3 a, double3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(double3 a) { return std::sqrt(dot(a, a)); }

/// Twice the area vector by the formula of the outline alone.
double3 area_of(const Points& points, const Polygon& polygon) {
  double3 sum{0, 0, 0};
  for (size_t i = 0; i < polygon.size(); ++i) {
    const double3 part =
        cross(minus(points[polygon[i]], points[polygon[0]]),
              minus(points[polygon[(i + 1) % polygon.size()]], points[polygon[0]]));
    sum = {sum.x + part.x, sum.y + part.y, sum.z + part.z};
  }
  return sum;
}

/// Every triangle turns as the outline does, and together they have its area: nothing is outside,
/// nothing overlaps. `flat`: as many may have no area.
void expect_cover(const Points& points, const Polygon& polygon, size_t flat = 0) {
  const CutPolygon made = cut(points, polygon);
  ASSERT_EQ(made.cut, Cut::done);
  const double3 whole = area_of(points, polygon);
  const double twice = length(whole);
  double sum = 0;
  size_t without_area = 0;
  std::vector<size_t> used(points.size(), 0);
  for (size_t t = 0; t < made.triangles.size(); t += 3) {
    const double3 a = points[made.triangles[t]], b = points[made.triangles[t + 1]],
                  c = points[made.triangles[t + 2]];
    const double3 n = cross(minus(b, a), minus(c, a));
    const double longest =
        std::max({length(minus(b, a)), length(minus(c, b)), length(minus(a, c))});
    without_area += !(length(n) > 1e-12 * longest * longest);
    ASSERT_GE(dot(n, whole), -1e-12 * twice * twice) << "triangle " << t / 3 << " is turned over";
    sum += length(n);
    for (size_t k = 0; k < 3; ++k) ++used[made.triangles[t + k]];
  }
  EXPECT_NEAR(sum, twice, 1e-9 * twice);
  EXPECT_LE(without_area, flat);
  for (const uint32_t v : polygon) EXPECT_GT(used[v], 0u) << "corner " << v;
}

/// The same surface, to the last index, from every first corner.
void expect_one_surface(const Points& points, Polygon polygon) {
  const CutPolygon first = cut(points, polygon);
  for (size_t k = 0; k < polygon.size(); ++k) {
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    EXPECT_EQ(cut(points, polygon).triangles, first.triangles) << "from corner " << k + 1;
  }
}

/// Into a plane that is no coordinate plane, away from the origin.
Points tilted(const Points& flat, double far = 0) {
  Points out;
  for (const double3& p : flat) {
    out.push_back({0.8 * p.x - 0.36 * p.y + far, 0.6 * p.x + 0.48 * p.y - far, 0.8 * p.y + far});
  }
  return out;
}

const Points panel{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
const Points arrow{{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}};
const Points keyhole{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                     {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
const Points midpoints{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                       {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
const Points one_side{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {2, 3, 0}};

Points star(size_t n, double inner) {
  Points out;
  for (size_t i = 0; i < n; ++i) {
    const double r = i % 2 == 0 ? 1 : inner, angle = 2 * pi * double(i) / double(n);
    out.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return out;
}

/// A ribbon that winds `turns` times round its begin.
Points spiral(size_t n, double turns) {
  Points out, back;
  for (size_t i = 0; i < n; ++i) {
    const double t = 1 + turns * double(i) / double(n - 1), angle = 2 * pi * t;
    out.push_back({t * std::cos(angle), t * std::sin(angle), 0});
    back.push_back({(t + 0.4) * std::cos(angle), (t + 0.4) * std::sin(angle), 0});
  }
  out.insert(out.end(), back.rbegin(), back.rend());
  std::reverse(out.begin(), out.end());
  return out;
}

Points comb(size_t teeth) {
  Points out{{0, -1, 0}, {double(2 * teeth), -1, 0}};
  for (size_t k = teeth; k-- > 0;) {
    out.push_back({double(2 * k) + 2, 5, 0});
    out.push_back({double(2 * k) + 1, 0, 0});
  }
  out.push_back({0, 5, 0});
  return out;
}

TEST(Polygons, AreCoveredOnceWhateverTheirShape) {
  for (const Points& flat :
       {panel, arrow, midpoints, one_side, star(10, 0.3), star(37, 0.9), spiral(60, 3), comb(20)}) {
    for (const Points& points : {flat, tilted(flat), tilted(flat, 1000)}) {
      const Polygon polygon = in_order(points.size());
      expect_cover(points, polygon);
      expect_one_surface(points, polygon);
      Polygon back(polygon.rbegin(), polygon.rend());
      expect_cover(points, back);
    }
  }
}

TEST(Polygons, HolesThatABridgeJoinsStayOpen) {
  for (const Points& points : {keyhole, tilted(keyhole)}) {
    expect_cover(points, in_order(points.size()));
    EXPECT_NEAR(length(area_of(points, in_order(points.size()))), 2 * 12, 1e-12);
    expect_one_surface(points, in_order(points.size()));
  }
}

// As at the poles of a globe of quads.
TEST(Polygons, CornersInOnePlaceAreCutTogether) {
  expect_cover({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 1, 0}}, in_order(4), 1);
  expect_cover({{0.5, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}}, in_order(4), 1);
}

TEST(Polygons, RandomOutlinesAreCovered) {
  std::mt19937 random(5);
  const auto real = [&] { return double(random()) / 4294967296.0; };
  for (int round = 0; round < 300; ++round) {
    const size_t n = 4 + random() % 40;
    std::vector<double> angles(n);
    for (double& a : angles) a = 2 * pi * real();
    std::sort(angles.begin(), angles.end());
    double widest = angles[0] + 2 * pi - angles[n - 1];
    for (size_t i = 1; i < n; ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
    if (widest > 3) continue;  // else the outline goes round its middle
    Points points;
    for (const double a : angles) {
      const double r = 0.2 + real();
      points.push_back({r * std::cos(a), r * std::sin(a), 0});
    }
    expect_cover(tilted(points), in_order(n));
  }
}

TEST(Polygons, WarpedQuadsAreCutAlongTheShorterDiagonal) {
  const Points saddle{{0, 0, 0}, {1, 0, 0.3}, {1.4, 1.4, 0}, {0, 1, 0.3}};
  expect_one_surface(saddle, in_order(4));
  EXPECT_EQ(cut(saddle, in_order(4)).triangles.size(), 6u);
  for (Polygon numbers : {Polygon{0, 1, 2, 3}, Polygon{2, 3, 0, 1}, Polygon{1, 2, 3, 0}}) {
    Points moved(4);
    for (size_t k = 0; k < 4; ++k) moved[numbers[k]] = saddle[k];
    const auto triangles = cut(moved, numbers).triangles;
    for (size_t t = 0; t < 6; t += 3) {
      EXPECT_EQ(std::count(&triangles[t], &triangles[t] + 3, numbers[1]), 1) << "1-3 is shorter";
      EXPECT_EQ(std::count(&triangles[t], &triangles[t] + 3, numbers[3]), 1);
    }
  }
}

/// A limacon turns to the left everywhere and goes twice round what its inner loop encloses.
TEST(Polygons, ALoopWithinALoopCrossesFromAnyFirstCorner) {
  for (const size_t n : {size_t(13), size_t(25), size_t(60)}) {
    Points points;
    for (size_t i = 0; i < n; ++i) {
      const double angle = 2 * pi * (double(i) + 0.3) / double(n), r = 0.5 + std::cos(angle);
      points.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
    for (size_t k = 0; k < n; ++k) {
      std::rotate(points.begin(), points.begin() + 1, points.end());
      EXPECT_EQ(cut(points, in_order(n)).cut, Cut::crossing) << n << " corners, from " << k + 1;
    }
  }
}

TEST(Polygons, WhatGoesRoundNothingIsNotCut) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, in_order(4)).cut, Cut::no_area);
  EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, in_order(4)).cut, Cut::no_area);
  EXPECT_EQ(cut(Points(5, double3{3, 1, 2}), in_order(5)).cut, Cut::no_area);
  // One lobe larger than the other.
  EXPECT_EQ(cut(tilted({{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 1, 0}}), in_order(4)).cut,
            Cut::crossing);
  Points pentagram;
  for (int i = 0; i < 5; ++i) {
    pentagram.push_back({std::cos(4 * pi * i / 5), std::sin(4 * pi * i / 5), 1});
  }
  EXPECT_EQ(cut(pentagram, in_order(5)).cut, Cut::crossing) << "all of its corners are convex";
}

TEST(Polygons, AnyFiniteCoordinatesAreJudged) {
  for (const double scale : {1e-300, 1e-150, 1e-20, 1e20, 1e150, 1e300}) {
    Points points = panel;
    for (double3& p : points) p = {p.x * scale, p.y * scale, p.z * scale};
    EXPECT_EQ(cut(points, in_order(6)).triangles, cut(panel, in_order(6)).triangles) << scale;
  }
}

// A hundred thousand corners, and an outline that every ear has to be compared with.
TEST(Polygons, TimeFollowsTheCorners) {
  for (const Points& points :
       {star(100000, 0.7), star(100000, 0.9999), spiral(50000, 40), comb(50000), star(100000, 1)}) {
    const auto start = std::chrono::steady_clock::now();
    const Cut what = cut(points, in_order(points.size())).cut;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_TRUE(what == Cut::done || what == Cut::too_long) << int(what);
    EXPECT_LT(seconds.count(), 10);
  }
  EXPECT_NE(to_text(Cut::too_long, 100000).find("has 100000 corners"), std::string::npos);
}

TEST(Polygons, TakesNoMoreMemoryThanItMay) {
  MemoryLimit memory(3000, 0);
  PolygonCutter cutter(memory);
  const Points points = star(1000, 0.5);
  std::vector<uint32_t> out(3 * 998);
  EXPECT_EQ(cutter.cut(points, in_order(1000), out.data()), Cut::no_memory);
}

}  // namespace
}  // namespace weft::io::test::polygon
