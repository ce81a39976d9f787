// Pairs that a world finds against those of the exact search.
#include "io/recall.h"

#include "io/predicted_recall.h"
#include "weft/weft.hpp"

#include "reference/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace weft::io {
namespace {

using reference::SplitMix;

MeetingCloth cloth_of(std::vector<double3> points, double distance) {
  MeetingCloth cloth;
  cloth.positions = std::move(points);
  cloth.distance = distance;
  return cloth;
}

std::vector<double3> cloud(size_t count, uint64_t seed, double3 low = {0, 0, 0}) {
  SplitMix random(seed);
  std::vector<double3> points;
  for (size_t i = 0; i < count; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.push_back({low.x + x, low.y + y, low.z + z});
  }
  return points;
}

SelfCollisionDesc staggered(double distance, double cell, uint32_t grids, GridShifts shifts) {
  SelfCollisionDesc desc;
  desc.search = PairSearch::staggered;
  desc.distance = distance;
  desc.cell = cell;
  desc.grids = grids;
  desc.shifts = shifts;
  return desc;
}

/// A world of free points, and what it finds of them.
class Points {
 public:
  Points(Precision precision, const SelfCollisionDesc& search) {
    context_ = std::move(*Context::create({}));
    WorldDesc desc;
    desc.precision = precision;
    world_ = std::move(*context_.create_world(desc));
    EXPECT_EQ(world_.set_self_collision(search), Status::ok);
    distance_ = search.distance;
  }
  void add(const std::vector<double3>& points, const ClothSettings& settings = {}) {
    NetworkDesc network;
    network.positions = View<double3>(points);
    ClothDesc cloth;
    static_cast<ClothSettings&>(cloth) = settings;
    cloth.fabric = *context_.cook(network);
    ids_.push_back(*world_.create_cloth(cloth));
    sizes_.push_back(points.size());
    settings_.push_back(settings);
  }
  /// As the world has them.
  std::vector<MeetingCloth> cloths() {
    std::vector<MeetingCloth> all;
    for (size_t i = 0; i < ids_.size(); ++i) {
      std::vector<double3> points(sizes_[i]);
      EXPECT_EQ(world_.read_positions(ids_[i], points.data()), Status::ok);
      const ClothSettings& s = settings_[i];
      const double distance = s.collision_distance > 0 ? s.collision_distance : distance_;
      all.push_back({std::move(points), distance, s.collides_itself != 0, s.collides_others != 0,
                     s.collision_layers});
    }
    return all;
  }
  Recall recall() {
    const auto found = world_.near_pairs(true);
    EXPECT_TRUE(found);
    return compare_pairs(ids_, cloths(), *found);
  }

 private:
  Context context_;
  World world_;
  std::vector<ClothId> ids_;
  std::vector<size_t> sizes_;
  std::vector<ClothSettings> settings_;
  double distance_ = 0;
};

Recall recall_of(const std::vector<double3>& points, const SelfCollisionDesc& search,
                 Precision precision = Precision::float32) {
  Points world(precision, search);
  world.add(points);
  return world.recall();
}

SelfCollisionDesc complete(double distance) {
  SelfCollisionDesc desc;
  desc.distance = distance;
  return desc;
}

void expect_all(const std::vector<double3>& points, double distance, uint64_t pairs,
                const std::string& what) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    const Recall recall = recall_of(points, complete(distance), precision);
    EXPECT_EQ(recall.pairs_true, pairs) << what;
    EXPECT_EQ(recall.pairs_found, pairs) << what;
    EXPECT_EQ(recall.pairs_wrong, 0u) << what;
  }
}

TEST(Recall, OfTheCompleteSearchIsOneOnTheKnownSets) {
  expect_all(cloud(20000, 42), 0.036840315, 40471, "uniform cloud");
  for (const double shift : {0.0, -1000.0}) {
    std::vector<double3> lattice;
    for (int i = 0; i < 1728; ++i) {
      lattice.push_back({i % 12 + shift, i / 12 % 12 + shift, i / 144 + shift});
    }
    expect_all(lattice, 1, 0, "lattice");
    expect_all(lattice, 1.0000001, 4752, "lattice");
    expect_all(lattice, 1.5, 13464, "lattice");
  }
  expect_all(std::vector<double3>(1500, double3{1, 2, 3}), 0.01, 1124250, "one place");
}

TEST(Recall, OfTheCompleteSearchIsOneOnRandomSets) {
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    SplitMix random(seed);
    const auto count = size_t(1 + 3000 * random.uniform());
    const double3 low{300 * random.uniform() - 150, random.uniform(), -70 * random.uniform()};
    const double distance = std::pow(10, -3 + 2.5 * random.uniform());
    std::vector<double3> points = cloud(count, seed + 100, low);
    if (seed % 3 == 0) {
      for (double3& p : points) p.y = low.y;  // a sheet
    }
    if (seed % 4 == 0) points.insert(points.end(), points.begin(), points.begin() + count / 2);
    const Recall recall =
        recall_of(points, complete(distance), seed % 2 ? Precision::float32 : Precision::float64);
    EXPECT_EQ(recall.pairs_found, recall.pairs_true) << "seed " << seed;
    EXPECT_EQ(recall.pairs_wrong, 0u) << "seed " << seed;
  }
}

TEST(Recall, OfTheCompleteSearchIsOneInLargePlaces) {
  SplitMix random(4);
  std::vector<double3> points;
  for (int i = 0; i < 2000; ++i) {
    const double3 p{2e6 * random.uniform() - 1e6, 2e6 * random.uniform() - 1e6,
                    2e6 * random.uniform() - 1e6};
    points.push_back(p);
    points.push_back({p.x + 1.5e-3 * random.uniform(), p.y, p.z});
  }
  // Floats are there 1/16 m apart: some of the pairs coincide, the others part.
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    const Recall recall = recall_of(points, complete(1e-3), precision);
    EXPECT_GT(recall.pairs_true, 1000u);
    EXPECT_EQ(recall.pairs_found, recall.pairs_true);
    EXPECT_EQ(recall.pairs_wrong, 0u);
  }
}

// Whether two points of such a lattice are nearer is a matter of the last bit.
TEST(Recall, OfPairsAtTheDistanceItselfIsOne) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    for (const double spacing : {0.1, 0.3, 1.0 / 3}) {
      for (const double shift : {0.0, -17.3}) {
        std::vector<double3> lattice;
        for (int i = 0; i < 1000; ++i) {
          lattice.push_back(
              {i % 10 * spacing + shift, i / 10 % 10 * spacing + shift, i / 100 * spacing + shift});
        }
        for (const double square : {1.0, 2.0, 3.0, 4.0}) {
          const double r = std::sqrt(square) * spacing;
          for (const SelfCollisionDesc& search :
               {complete(r), staggered(r, 2.000001 * r, 8, GridShifts::corner)}) {
            const Recall recall = recall_of(lattice, search, precision);
            EXPECT_EQ(recall.pairs_found, recall.pairs_true) << spacing << ' ' << square;
            EXPECT_EQ(recall.pairs_wrong, 0u) << spacing << ' ' << square;
          }
        }
      }
    }
  }
}

TEST(Recall, OfStaggeredGridsAtManyPlacesIsThePredictedOne) {
  constexpr double r = 0.036840315;
  constexpr int places = 32;
  struct Case {
    double cell;
    uint32_t grids;
    GridShifts shifts;
  };
  for (const Case& c : {Case{1, 1, GridShifts::corner}, Case{2, 1, GridShifts::corner},
                        Case{2, 2, GridShifts::corner}, Case{1, 4, GridShifts::corner},
                        Case{2, 4, GridShifts::diagonal}}) {
    const SelfCollisionDesc search = staggered(r, c.cell * r, c.grids, c.shifts);
    SplitMix random(7);
    double sum = 0, expected = 0;
    for (int i = 0; i < places; ++i) {
      const double3 low{random.uniform(), random.uniform(), random.uniform()};
      const std::vector<double3> points = cloud(5000, 42 + uint64_t(i), low);
      const Recall recall = recall_of(points, search);
      EXPECT_EQ(recall.pairs_wrong, 0u);
      sum += recall.recall() / places;
      expected += expect_recall(search, {cloth_of(points, r)}).of_pairs.value() / places;
    }
    EXPECT_NEAR(sum, expected, 0.01) << c.grids << " grids, " << c.cell;
    EXPECT_NEAR(sum, predicted_recall(search).value(), 0.015) << c.grids << " grids, " << c.cell;
  }
}

TEST(Recall, OfEnoughStaggeredGridsIsOne) {
  constexpr double r = 0.036840315;
  for (const SelfCollisionDesc& search : {staggered(r, 2.000001 * r, 8, GridShifts::corner),
                                          staggered(r, 4.000001 * r, 4, GridShifts::diagonal)}) {
    const Recall recall = recall_of(cloud(20000, 42), search);
    EXPECT_EQ(recall.pairs_true, 40471u);
    EXPECT_EQ(recall.pairs_found, 40471u);
    EXPECT_EQ(recall.pairs_wrong, 0u);
  }
}

TEST(Recall, OfTheCompleteSearchIsOneOfSeveralClothsWhateverTheirKeys) {
  for (uint64_t seed = 1; seed <= 24; ++seed) {
    SplitMix random(seed);
    Points world(seed % 2 ? Precision::float32 : Precision::float64, complete(0.05));
    for (int i = 0; i < 4; ++i) {
      ClothSettings settings;
      if (random.uniform() < 0.5) settings.collision_distance = 0.01 + 0.1 * random.uniform();
      settings.collides_itself = random.uniform() < 0.7;
      settings.collides_others = random.uniform() < 0.8;
      if (random.uniform() < 0.5) settings.collision_layers = uint32_t(8 * random.uniform());
      const double3 low{random.uniform() - 20, 3 * random.uniform(), 0.3 * random.uniform()};
      world.add(cloud(size_t(1 + 900 * random.uniform()), seed * 100 + uint64_t(i), low), settings);
    }
    const Recall recall = world.recall();
    EXPECT_EQ(recall.pairs_found, recall.pairs_true) << "seed " << seed;
    EXPECT_EQ(recall.pairs_wrong, 0u) << "seed " << seed;
  }
}

TEST(Recall, CountsWhatIsMissedWrongAndTwice) {
  const std::vector<MeetingCloth> cloths{cloth_of({{0, 0, 0}, {.5, 0, 0}, {5, 0, 0}}, 1),
                                         cloth_of({{0, .5, 0}}, 1)};
  const std::vector<ClothId> ids{ClothId{1, 1}, ClothId{2, 1}};
  const std::vector<NearPair> all{
      {ids[0], ids[0], 0, 1}, {ids[0], ids[1], 0, 0}, {ids[0], ids[1], 1, 0}};
  const auto expect = [&](std::vector<NearPair> pairs, uint64_t found, uint64_t wrong) {
    const Recall recall = compare_pairs(ids, cloths, View<NearPair>(pairs));
    EXPECT_EQ(recall.pairs_true, 3u);
    EXPECT_EQ(recall.pairs_found, found);
    EXPECT_EQ(recall.pairs_wrong, wrong);
  };
  expect(all, 3, 0);
  expect({all[0], all[2]}, 2, 0);
  expect({all[0], all[2], all[0]}, 2, 1);                          // twice
  expect({all[0], {ids[0], ids[0], 0, 2}}, 1, 1);                  // too far
  expect({{ids[0], ids[0], 1, 0}, {ids[1], ids[0], 0, 0}}, 0, 2);  // the wrong way round
  expect({{ids[0], ids[0], 0, 0}, {ids[0], ids[0], 0, 9}, {ids[0], ClothId{9, 1}, 0, 0}}, 0, 3);
}

TEST(Recall, OfNoPairsIsOne) { EXPECT_EQ(Recall{}.recall(), 1); }

TEST(ExpectedRecall, OfACloudHasBothFormulasAndOfASheetOne) {
  const SelfCollisionDesc search = staggered(0.08, 0.16, 2, GridShifts::corner);
  const ExpectedRecall of_cloud = expect_recall(search, {cloth_of(cloud(4000, 3), 0.08)});
  ASSERT_TRUE(of_cloud.of_cloud && of_cloud.of_pairs);
  EXPECT_NEAR(*of_cloud.of_pairs, *of_cloud.of_cloud, 0.03);
  std::vector<double3> sheet = cloud(4000, 3);
  for (double3& p : sheet) p.z = 0.5;
  const ExpectedRecall of_sheet = expect_recall(search, {cloth_of(sheet, 0.08)});
  EXPECT_FALSE(of_sheet.of_cloud.has_value());
  // In a plane no pair is separated along its normal: more of them share a cell.
  EXPECT_GT(of_sheet.of_pairs.value(), *of_cloud.of_pairs);
}

TEST(ExpectedRecall, IsUnknownWithAWindowAndOneWhenComplete) {
  SelfCollisionDesc search = staggered(0.08, 0.16, 2, GridShifts::corner);
  search.window = 3;
  const std::vector<MeetingCloth> cloths{cloth_of(cloud(300, 3), 0.08)};
  EXPECT_FALSE(expect_recall(search, cloths).of_cloud || expect_recall(search, cloths).of_pairs);
  EXPECT_EQ(expect_recall(complete(0.08), cloths).of_cloud, 1);
  EXPECT_EQ(expect_recall(complete(0.08), cloths).of_pairs, 1);
}

TEST(ExpectedRecall, OfClothsWithDistancesOfTheirOwnIsOfThePairs) {
  const SelfCollisionDesc search = staggered(0.08, 0.16, 2, GridShifts::corner);
  const ExpectedRecall expected =
      expect_recall(search, {cloth_of(cloud(2000, 3), 0.08), cloth_of(cloud(2000, 4), 0.12)});
  EXPECT_FALSE(expected.of_cloud.has_value());
  EXPECT_TRUE(expected.of_pairs.has_value());
}

}  // namespace
}  // namespace weft::io
