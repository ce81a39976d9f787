// The pairs that a search names, against all pairs looked at in double.
#include "reference/networks.h"
#include "reference/random.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

namespace weft_tests::self_collision_search {
namespace {

using NamedPair = std::array<uint32_t, 4>;  ///< cloths by creation, and vertices

/// Points of a cloth of a world, as it holds them.
struct PointCloth {
  std::vector<Vec> x;
  double distance = 0;  ///< 0: the world's
  uint32_t layers = ~0u;
  bool itself = true, others = true;
  weft::ClothId id;
};

void add_point_cloth(TestWorld& test, PointCloth& cloth, bool spread = true) {
  NetworkParts parts;
  for (size_t i = 0; i < cloth.x.size(); ++i) {
    parts.positions.push_back(spread ? Vec{1e4 * double(i + 1), 0, 0} : cloth.x[i]);
  }
  parts.start = cloth.x;
  parts.masses.assign(cloth.x.size(), 1);
  weft::ClothDesc desc;
  desc.collision_distance = cloth.distance;
  desc.collision_layers = cloth.layers;
  desc.collides_itself = cloth.itself;
  desc.collides_others = cloth.others;
  cloth.id = add_network(test, parts, desc);
}

/// All pairs nearer than the mean of their distances. `x` is read from the world.
std::vector<NamedPair> all_near_pairs(TestWorld& test, std::vector<PointCloth>& cloths,
                                      double distance) {
  for (PointCloth& cloth : cloths) cloth.x = test.positions(cloth.id, uint32_t(cloth.x.size()));
  std::vector<NamedPair> found;
  const auto own = [&](const PointCloth& c) { return c.distance > 0 ? c.distance : distance; };
  for (uint32_t a = 0; a < cloths.size(); ++a)
    for (uint32_t b = a; b < cloths.size(); ++b) {
      const PointCloth &one = cloths[a], &two = cloths[b];
      if (a == b ? !one.itself : !(one.others && two.others && (one.layers & two.layers))) continue;
      const double r = 0.5 * (own(one) + own(two));
      for (uint32_t i = 0; i < one.x.size(); ++i)
        for (uint32_t j = a == b ? i + 1 : 0; j < two.x.size(); ++j) {
          const Vec d = one.x[i] - two.x[j];
          if (dot(d, d) < r * r) found.push_back({a, i, b, j});
        }
    }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<NamedPair> named_pairs(TestWorld& test, const std::vector<PointCloth>& cloths,
                                   bool with_excluded = false) {
  std::vector<NamedPair> named;
  const auto index = [&](weft::ClothId id) {
    for (uint32_t k = 0; k < cloths.size(); ++k)
      if (cloths[k].id == id) return k;
    return ~0u;
  };
  const weft::View<weft::NearPair> pairs = test.take(test.world().near_pairs(with_excluded));
  for (uint32_t k = 0; k < pairs.count; ++k) {
    const weft::NearPair& p = pairs[k];
    named.push_back({index(p.cloth_a), p.vertex_a, index(p.cloth_b), p.vertex_b});
  }
  return named;
}

/// Nothing twice, in order, and nothing that is not among `all`; how many are.
size_t count_true_pairs(const std::vector<NamedPair>& named, const std::vector<NamedPair>& all) {
  const auto ascending = [](const NamedPair& a, const NamedPair& b) {
    return std::array{a[0], a[1], a[2], a[3]} < std::array{b[0], b[1], b[2], b[3]};
  };
  EXPECT_TRUE(std::is_sorted(named.begin(), named.end(), ascending)) << "not ascending";
  EXPECT_EQ(std::set<NamedPair>(named.begin(), named.end()).size(), named.size()) << "one twice";
  size_t found = 0;
  for (const NamedPair& p : named) found += std::binary_search(all.begin(), all.end(), p);
  EXPECT_EQ(found, named.size()) << "one is not near";
  return found;
}

enum class Spread { uniform, clusters, line, plane, duplicates, wide, borders, one_cell, axis_far };
constexpr Spread every_spread[] = {Spread::uniform, Spread::clusters,   Spread::line,
                                   Spread::plane,   Spread::duplicates, Spread::wide,
                                   Spread::borders, Spread::one_cell,   Spread::axis_far};
const char* name(Spread spread) {
  const char* const names[] = {"uniform", "clusters", "line",     "plane",   "duplicates",
                               "wide",    "borders",  "one_cell", "axis_far"};
  return names[int(spread)];
}

/// `n` points for a distance of r, mostly so that each has a few neighbours.
std::vector<Vec> spread_out(Spread spread, size_t n, double r, reference::SplitMix& random) {
  std::vector<Vec> x(n);
  const double half = 0.5 * r * std::cbrt(double(n));
  for (size_t i = 0; i < n; ++i) {
    Vec& p = x[i];
    switch (spread) {
      case Spread::uniform:
        p = random.noise(half);
        break;
      case Spread::clusters:
        p = Vec{20 * r * double(i % 7), -30 * r * double(i % 3), 0} + random.noise(1.5 * r);
        break;
      case Spread::line:
        p = Vec{0, 0, 0.3 * r * double(i)} + random.noise(0.1 * r);
        break;
      case Spread::plane:
        p = random.noise(0.5 * r * std::sqrt(double(n)));
        p.x = 0;
        break;
      case Spread::duplicates:
        p = i % 3 == 0 ? random.noise(half) : x[i / 3 * 3];
        break;
      case Spread::wide:  // pairs, all over the place
        p = i % 2 == 0 ? random.noise(1e6) : x[i - 1] + random.noise(r);
        break;
      case Spread::borders:
        p = r * Vec{std::floor(12 * random.uniform()), std::floor(12 * random.uniform()),
                    std::floor(12 * random.uniform()) - 1000};
        break;
      case Spread::one_cell:
        p = random.noise(0.1 * r);
        break;
      case Spread::axis_far:  // a single one far along each axis makes a huge extent
        p = random.noise(half);
        if (i == 0) p.x = 3e5;
        if (i == 1) p.y = -7e5;
        if (i == 2) p.z = 2e5;
        break;
    }
  }
  return x;
}

class SelfCollisionSearch : public testing::TestWithParam<std::tuple<Spread, weft::Precision>> {
 protected:
  const Spread spread = std::get<0>(GetParam());

  weft::WorldDesc world() const { return plain_world(std::get<1>(GetParam())); }
  /// Float does not tell a millimetre from none at 1e6 m.
  double distance() const {
    return spread == Spread::wide && std::get<1>(GetParam()) == weft::Precision::float64 ? 1e-3
                                                                                         : 0.125;
  }
};

TEST_P(SelfCollisionSearch, CompleteNamesThePairsThatAreNear) {
  reference::SplitMix random(100 + uint64_t(spread));
  for (const size_t n : {size_t(1), size_t(2), size_t(31), size_t(33), size_t(500), size_t(1500)}) {
    if (n > 500 && spread == Spread::one_cell) continue;
    SCOPED_TRACE(n);
    TestWorld test(world());
    weft::SelfCollisionDesc desc;
    desc.distance = distance();
    test.check(test.world().set_self_collision(desc));
    std::vector<PointCloth> cloths(1);
    cloths[0].x = spread_out(spread, n, distance(), random);
    add_point_cloth(test, cloths[0]);
    const std::vector<NamedPair> all = all_near_pairs(test, cloths, distance());
    if (n >= 500) {
      EXPECT_GT(all.size(), 20u) << "nothing is tried";
    }
    EXPECT_EQ(named_pairs(test, cloths), all);
    EXPECT_EQ(test.take(test.world().contacts()).touching, all.size());
  }
}

/// Four cloths, in one heap, of unlike distances and layers; one does not meet itself, one no
/// other.
TEST_P(SelfCollisionSearch, CompleteKnowsWhoMeetsWhom) {
  reference::SplitMix random(200 + uint64_t(spread));
  TestWorld test(world());
  weft::SelfCollisionDesc desc;
  desc.distance = distance();
  test.check(test.world().set_self_collision(desc));
  std::vector<PointCloth> cloths(5);
  const std::vector<Vec> x = spread_out(spread, 500, distance(), random);
  for (size_t i = 0; i < x.size(); ++i) cloths[i / 2 % 5].x.push_back(x[i]);
  cloths[1].distance = 0.4 * distance();
  cloths[1].layers = 2;
  cloths[2].distance = 1.7 * distance();
  cloths[2].itself = false;
  cloths[3].layers = 5;
  cloths[4].others = false;
  for (PointCloth& cloth : cloths) add_point_cloth(test, cloth);
  const std::vector<NamedPair> all = all_near_pairs(test, cloths, distance());
  EXPECT_EQ(named_pairs(test, cloths), all);
}

/// Some of the pairs, each once; with eight corner grids of twice the distance or four diagonal
/// ones of four times all, wherever the points are.
TEST_P(SelfCollisionSearch, StaggeredNamesSomeOrAll) {
  reference::SplitMix random(300 + uint64_t(spread));
  std::vector<PointCloth> cloths(2);
  const std::vector<Vec> x = spread_out(spread, 400, distance(), random);
  for (size_t i = 0; i < x.size(); ++i) cloths[i % 5 == 0].x.push_back(x[i]);
  cloths[1].distance = 0.8 * distance();
  const struct {
    weft::GridShifts shifts;
    uint32_t grids, window;
    double cell;  ///< in distances
    bool all;
  } recipes[] = {
      {weft::GridShifts::corner, 8, 0, 2, true},     {weft::GridShifts::corner, 8, 0, 3.7, true},
      {weft::GridShifts::diagonal, 4, 0, 4, true},   {weft::GridShifts::diagonal, 4, 0, 6.1, true},
      {weft::GridShifts::corner, 8, 3, 2, false},    {weft::GridShifts::corner, 4, 0, 1, false},
      {weft::GridShifts::corner, 2, 5, 2, false},    {weft::GridShifts::diagonal, 5, 2, 4, false},
      {weft::GridShifts::diagonal, 1, 0, 0.5, false}};
  for (const auto& recipe : recipes) {
    SCOPED_TRACE(testing::Message()
                 << recipe.grids << " grids of " << recipe.cell << ", window " << recipe.window);
    TestWorld test(world());
    weft::SelfCollisionDesc desc;
    desc.search = weft::PairSearch::staggered;
    desc.distance = distance();
    desc.shifts = recipe.shifts;
    desc.grids = recipe.grids;
    desc.window = recipe.window;
    desc.cell = recipe.cell * distance();
    test.check(test.world().set_self_collision(desc));
    for (PointCloth& cloth : cloths) add_point_cloth(test, cloth);
    const std::vector<NamedPair> all = all_near_pairs(test, cloths, distance());
    const std::vector<NamedPair> named = named_pairs(test, cloths);
    const size_t found = count_true_pairs(named, all);
    if (recipe.all) {
      EXPECT_EQ(found, all.size());
    }
    EXPECT_EQ(test.take(test.world().contacts()).touching, named.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Every, SelfCollisionSearch,
                         testing::Combine(testing::ValuesIn(every_spread), both_precisions()),
                         [](const auto& info) {
                           return std::string(name(std::get<0>(info.param))) + "_" +
                                  weft::to_string(std::get<1>(info.param));
                         });

/// Lattices and duplicates whose numbers of pairs are known.
TEST(SelfCollisionCounts, OfALatticeAreThoseOfItsNeighbours) {
  for (const double shift : {0.0, -1000.0})
    for (const auto& [distance, expected] :
         {std::pair{1.0, 0u}, {1.0000001, 4752u}, {1.5, 13464u}}) {
      TestWorld test(plain_world(weft::Precision::float64));
      weft::SelfCollisionDesc desc;
      desc.distance = distance;
      test.check(test.world().set_self_collision(desc));
      std::vector<PointCloth> cloths(1);
      for (int i = 0; i < 1728; ++i) {
        cloths[0].x.push_back({shift + i % 12, shift + i / 12 % 12, shift + i / 144});
      }
      add_point_cloth(test, cloths[0]);
      EXPECT_EQ(test.take(test.world().contacts()).touching, expected) << shift;
    }
}

/// f(t) = 1 - 9t/8 + 6 t^2/5 pi - t^3/8 pi, of a grid whose cells are r/t.
TEST(SelfCollisionCounts, OfOneGridFollowTheFormula) {
  constexpr double pi = 3.14159265358979323846, r = 0.04;
  reference::SplitMix random(42);
  std::vector<Vec> x(4000);
  for (Vec& p : x) p = random.noise(0.3);
  for (const double t : {1.0, 0.5, 0.25}) {
    double mean = 0;
    for (int origin = 0; origin < 32; ++origin) {
      TestWorld test(plain_world(weft::Precision::float64));
      weft::SelfCollisionDesc desc;
      desc.search = weft::PairSearch::staggered;
      desc.distance = r;
      desc.cell = r / t;
      desc.grids = 1;
      test.check(test.world().set_self_collision(desc));
      const Vec shift = Vec{5, 5, 5} + random.noise(r / t);
      std::vector<PointCloth> cloths(1);
      for (const Vec& p : x) cloths[0].x.push_back(p + shift);
      add_point_cloth(test, cloths[0]);
      static size_t all = 0;
      if (all == 0) all = all_near_pairs(test, cloths, r).size();
      mean += double(test.take(test.world().near_pairs()).count) / double(all) / 32;
    }
    const double f = 1 - 9 * t / 8 + 6 * t * t / (5 * pi) - t * t * t / (8 * pi);
    EXPECT_NEAR(mean, f, 0.01) << t;
  }
}

/// Those whose rest distance is below the distance are named when asked for only, and counted.
TEST(SelfCollisionCounts, ExcludedPairsAreNamedOnDemand) {
  for (const weft::PairSearch search : {weft::PairSearch::complete, weft::PairSearch::staggered}) {
    reference::SplitMix random(5);
    TestWorld test(plain_world(weft::Precision::float64));
    weft::SelfCollisionDesc desc;
    desc.search = search;
    desc.distance = 0.125;
    desc.cell = 0.25;
    test.check(test.world().set_self_collision(desc));
    std::vector<PointCloth> cloths(1);
    cloths[0].x = spread_out(Spread::uniform, 300, 0.125, random);
    add_point_cloth(test, cloths[0], false);
    const std::vector<NamedPair> all = all_near_pairs(test, cloths, 0.125);
    EXPECT_EQ(named_pairs(test, cloths, true), all);
    EXPECT_TRUE(named_pairs(test, cloths).empty());
    EXPECT_EQ(test.take(test.world().contacts()).excluded, all.size());
    const uint64_t hash = test.hash();
    test.step(1.0 / 60, 5);
    EXPECT_EQ(test.hash(), hash) << "an excluded pair acts";
    EXPECT_EQ(named_pairs(test, cloths, true), all);
  }
}

}  // namespace
}  // namespace weft_tests::self_collision_search
