// The exact search against every pair compared with every other.
#include "io/exact_pairs.h"

#include "reference/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace weft::io {
namespace {

using reference::SplitMix;

std::vector<double3> cloud(size_t count, uint64_t seed, double3 low = {0, 0, 0}, double side = 1) {
  SplitMix random(seed);
  std::vector<double3> points;
  for (size_t i = 0; i < count; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.push_back({low.x + side * x, low.y + side * y, low.z + side * z});
  }
  return points;
}

MeetingCloth cloth_of(std::vector<double3> points, double distance) {
  MeetingCloth cloth;
  cloth.positions = std::move(points);
  cloth.distance = distance;
  return cloth;
}

/// Every pair of every two cloths, by the words of the interface.
std::vector<MeetingPair> brute(const std::vector<MeetingCloth>& cloths) {
  std::vector<MeetingPair> pairs;
  for (uint32_t a = 0; a < cloths.size(); ++a) {
    for (uint32_t b = a; b < cloths.size(); ++b) {
      const MeetingCloth &c = cloths[a], &d = cloths[b];
      if (a == b ? !c.itself : !(c.others && d.others && (c.layers & d.layers))) continue;
      const double r = (c.distance + d.distance) / 2;
      for (uint32_t v = 0; v < c.positions.size(); ++v) {
        for (uint32_t w = a == b ? v + 1 : 0; w < d.positions.size(); ++w) {
          const double x = c.positions[v].x - d.positions[w].x;
          const double y = c.positions[v].y - d.positions[w].y;
          const double z = c.positions[v].z - d.positions[w].z;
          if ((x * x + y * y) + z * z < r * r) pairs.push_back({a, v, b, w});
        }
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void expect_brute(const std::vector<MeetingCloth>& cloths) {
  const std::vector<MeetingPair> truth = brute(cloths);
  EXPECT_EQ(list_near_pairs(cloths), truth);
  EXPECT_EQ(count_near_pairs(cloths), truth.size());
}

TEST(ExactPairs, AreThoseOfComparingAllWithAll) {
  for (const uint32_t count : {0u, 1u, 2u, 12u, 13u, 14u, 100u, 700u}) {
    for (const double r : {1e-9, 0.03, 0.2, 0.7, 3.0}) {
      SCOPED_TRACE(std::to_string(count) + " points, " + std::to_string(r));
      expect_brute({cloth_of(cloud(count, count + 1), r)});
      expect_brute({cloth_of(cloud(count, count + 2, {-1e3, 5e2, 7}), r)});
    }
  }
}

TEST(ExactPairs, OfLinesSheetsAndCrowds) {
  SplitMix random(5);
  std::vector<double3> line, sheet, crowd;
  for (int i = 0; i < 400; ++i) {
    line.push_back({0, random.uniform(), 0});
    sheet.push_back({random.uniform(), 0.25, random.uniform()});
    crowd.push_back({i % 3 ? 1e-3 * random.uniform() : random.uniform(), random.uniform() * 1e-3,
                     i % 2 ? 0 : 1.0});
  }
  for (const auto& points : {line, sheet, crowd}) {
    for (const double r : {1e-4, 0.01, 0.3}) expect_brute({cloth_of(points, r)});
  }
}

TEST(ExactPairs, OfTwoClothsTakeTheMeanDistance) {
  const std::vector<MeetingCloth> two{cloth_of({{0, 0, 0}}, 0.1), cloth_of({{0.19, 0, 0}}, 0.3)};
  EXPECT_EQ(count_near_pairs(two), 1u);
  EXPECT_EQ(meeting_distance(two[0], two[1], false), 0.2);
  EXPECT_EQ(count_near_pairs({cloth_of({{0, 0, 0}}, 0.1), cloth_of({{0.201, 0, 0}}, 0.3)}), 0u);
}

TEST(ExactPairs, OfSeveralClothsMeetAsTheirKeysSay) {
  for (uint32_t keys = 0; keys < 64; ++keys) {
    std::vector<MeetingCloth> cloths{cloth_of(cloud(90, 1), 0.1), cloth_of(cloud(150, 2), 0.2),
                                     cloth_of(cloud(70, 3), 0.15)};
    cloths[0].itself = keys & 1;
    cloths[0].others = keys & 2;
    cloths[1].itself = keys & 4;
    cloths[1].others = keys & 8;
    cloths[1].layers = keys & 16 ? 1 : 6;
    cloths[2].layers = keys & 32 ? 2 : 1;
    SCOPED_TRACE(keys);
    expect_brute(cloths);
  }
}

std::vector<double3> lattice(double shift) {
  std::vector<double3> points;
  for (int i = 0; i < 12 * 12 * 12; ++i) {
    points.push_back({i % 12 + shift, i / 12 % 12 + shift, i / 144 + shift});
  }
  return points;
}

TEST(ExactPairs, OfALatticeAreCountedStrictlyAndAnywhere) {
  for (const double shift : {0.0, -1000.0, 1048576.0}) {
    SCOPED_TRACE(shift);
    EXPECT_EQ(count_near_pairs({cloth_of(lattice(shift), 1)}), 0u);
    EXPECT_EQ(count_near_pairs({cloth_of(lattice(shift), 1.0000001)}), 4752u);
    EXPECT_EQ(count_near_pairs({cloth_of(lattice(shift), 1.5)}), 13464u);
  }
}

// splitmix64 seed 42, x, y, z of each point in turn.
TEST(ExactPairs, OfTheUniformCloudAreItsKnownNumber) {
  const std::vector<MeetingCloth> uniform{cloth_of(cloud(20000, 42), 0.036840315)};
  EXPECT_EQ(count_near_pairs(uniform), 40471u);
  EXPECT_EQ(list_near_pairs(uniform).size(), 40471u);
}

TEST(ExactPairs, OfCoincidentPointsAreAllOfThem) {
  const std::vector<double3> one(5000, double3{0.1, -2, 3});
  EXPECT_EQ(count_near_pairs({cloth_of(one, 1e-300)}), 0u);  // its square is zero
  EXPECT_EQ(count_near_pairs({cloth_of(one, 1e-3)}), 12497500u);
  EXPECT_EQ(list_near_pairs({cloth_of({one.begin(), one.begin() + 300}, 1e-3)}).size(), 44850u);
}

TEST(ExactPairs, OfTwoCrowdsAtTheDistanceItselfAreWithinEach) {
  std::vector<double3> crowds(40, double3{0.25, 0, 0});
  for (size_t i = 20; i < 40; ++i) crowds[i] = {0.25, 0, -1.25};
  EXPECT_EQ(count_near_pairs({cloth_of(crowds, 1.25)}), 380u);
  EXPECT_EQ(count_near_pairs({cloth_of(crowds, 1.2500000001)}), 780u);
}

TEST(ExactPairs, OfSmallDistancesInLargePlaces) {
  SplitMix random(9);
  std::vector<double3> points;
  for (int i = 0; i < 1500; ++i) {
    const double3 p{2e6 * random.uniform() - 1e6, 2e6 * random.uniform() - 1e6,
                    2e6 * random.uniform() - 1e6};
    points.push_back(p);
    points.push_back({p.x + 1.5e-3 * random.uniform(), p.y, p.z - 5e-4 * random.uniform()});
  }
  expect_brute({cloth_of(points, 1e-3)});
}

TEST(ExactPairs, AMillionPointsTakeSeconds) {
  const std::vector<MeetingCloth> million{cloth_of(cloud(1000000, 3), 0.005)};
  const double expected = 0.5e12 * (4.0 / 3) * 3.14159265358979 * 1.25e-7;
  EXPECT_NEAR(double(count_near_pairs(million)), expected, 0.02 * expected);
}

TEST(ExactPairs, RefuseWhatIsNotAPlace) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const std::vector<MeetingCloth> cloths{cloth_of({{0, 0, 0}}, 1),
                                           cloth_of({{0, 0, 0}, {0, bad, 0}}, 1)};
    try {
      count_near_pairs(cloths);
      FAIL() << "nothing was thrown";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind("vertex 1 of cloth 1", 0), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace weft::io
