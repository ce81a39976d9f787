// What a world is told of self-collision: every field is checked, equal descriptions change
// nothing, and pairs that rest too near to touch are counted.
#include <algorithm>
#include <array>
#include <cmath>

#include "reference/refusals.h"
#include "reference/networks.h"
#include "reference/random.h"

namespace weft_tests::self_collision {
namespace {

using weft::SelfCollisionDesc;

TEST(SelfCollision, EveryFieldIsChecked) {
  using Field = BadField<SelfCollisionDesc>;
  const std::vector<Field> fields{
      {"self_collision.search",
       [](SelfCollisionDesc& d, double v) { d.search = weft::PairSearch(int(v)); },
       {2, 77}},
      {"self_collision.distance", [](SelfCollisionDesc& d, double v) { d.distance = v; },
       not_positive},
      {"self_collision.friction", [](SelfCollisionDesc& d, double v) { d.friction = v; }, negative},
      {"self_collision.cell", [](SelfCollisionDesc& d, double v) { d.cell = v; }, not_positive},
      {"self_collision.shifts",
       [](SelfCollisionDesc& d, double v) { d.shifts = weft::GridShifts(int(v)); },
       {2, 77}},
      {"self_collision.grids",
       [](SelfCollisionDesc& d, double v) { d.grids = uint32_t(v); },
       {0, 3, 5, 6, 7, 9, 16, 64}},
      {"self_collision.grids",
       [](SelfCollisionDesc& d, double v) {
         d.grids = uint32_t(v);
         d.shifts = weft::GridShifts::diagonal;
       },
       {0, 65, 4e9}},
      {"self_collision.skin", [](SelfCollisionDesc& d, double v) { d.skin = v; }, not_finite},
  };
  TestWorld test;
  add_particles(test, {{0, 5, 0}, {1, 2, 3}});
  for (const bool set : {false, true}) {
    if (set) test.check(test.world().set_self_collision({}));
    for (const Field& field : fields)
      for (const double value : field.values) {
        SCOPED_TRACE(std::string(field.name) + " = " + std::to_string(value));
        SelfCollisionDesc bad;
        field.set(bad, value);
        expect_refused_unchanged(test, {field.name},
                                 [&] { return test.world().set_self_collision(bad); });
        EXPECT_EQ(test.world().near_pairs().status() == weft::Status::ok, set) << "it is not set";
      }
  }
  test.step(0.01);
}

TEST(SelfCollision, EveryNumberOfGridsThatItsShiftsHaveIsTaken) {
  TestWorld test;
  SelfCollisionDesc desc;
  for (const uint32_t grids : {1u, 2u, 4u, 8u}) {
    desc.grids = grids;
    test.check(test.world().set_self_collision(desc));
  }
  desc.shifts = weft::GridShifts::diagonal;
  for (desc.grids = 1; desc.grids <= 64; ++desc.grids) {
    test.check(test.world().set_self_collision(desc));
  }
}

TEST(SelfCollision, OnlyAnotherDescriptionWakes) {
  weft::WorldDesc world;
  world.gravity = {0, 0, 0};
  TestWorld test(world);
  weft::GridDesc grid;
  grid.rows = grid.columns = 5;
  weft::ClothDesc cloth;
  cloth.sleep_speed = 0.01;
  cloth.sleep_time = 0;
  const weft::ClothId id = test.add(grid, cloth);
  const auto sleeps_again = [&] {
    test.step(1.0 / 60, 3);
    return test.take(test.world().asleep(id));
  };
  const auto asleep = [&] { return test.take(test.world().asleep(id)); };
  ASSERT_TRUE(sleeps_again());
  test.check(test.world().clear_self_collision());
  EXPECT_TRUE(asleep()) << "there was none";
  SelfCollisionDesc desc;
  const std::function<void()> changes[] = {
      [] {},
      [&] { desc.distance += 1e-6; },
      [&] { desc.friction += 1e-6; },
      [&] { desc.cell += 1e-6; },
      [&] { desc.grids = 4; },
      [&] { desc.shifts = weft::GridShifts::diagonal; },
      [&] { desc.window = 3; },
      [&] { desc.skin = 0; },
      [&] { desc.search = weft::PairSearch::staggered; },
  };
  for (size_t k = 0; k < std::size(changes); ++k) {
    changes[k]();
    test.check(test.world().set_self_collision(desc));
    EXPECT_FALSE(asleep()) << "change " << k;
    ASSERT_TRUE(sleeps_again());
    test.check(test.world().set_self_collision(desc));
    EXPECT_TRUE(asleep()) << "the same again after change " << k;
  }
  test.check(test.world().clear_self_collision());
  EXPECT_FALSE(asleep());
}

/// Pairs of points nearer than a distance, by definition.
uint64_t near_pairs_of(const std::vector<Vec>& x, double distance) {
  uint64_t count = 0;
  for (size_t i = 0; i < x.size(); ++i)
    for (size_t j = i + 1; j < x.size(); ++j) {
      const Vec d = x[i] - x[j];
      count += dot(d, d) < distance * distance;
    }
  return count;
}

uint64_t excluded(TestWorld& test) { return test.take(test.world().contacts()).excluded; }

TEST(SelfCollision, CountsThePairsThatRestTooNearOfEveryKindOfCloth) {
  TestWorld test;
  SelfCollisionDesc desc;
  desc.distance = 0.15;
  EXPECT_EQ(excluded(test), 0u) << "without self-collision, without cloths";
  test.check(test.world().set_self_collision(desc));
  EXPECT_EQ(excluded(test), 0u);

  weft::GridDesc grid;
  grid.rows = 9;
  grid.columns = 17;  // 1/8 and 1/16 m apart
  test.add(grid, {});
  const auto offsets = [](double distance) {
    uint64_t count = 0;
    for (int r = 0; r < 9; ++r)
      for (int c = -16; c < 17; ++c) {
        if (r == 0 && c <= 0) continue;
        if (std::hypot(r / 8.0, c / 16.0) < distance) count += uint64_t((9 - r) * (17 - abs(c)));
      }
    return count;
  };
  EXPECT_EQ(excluded(test), offsets(0.15));

  reference::SplitMix random(6);
  std::vector<Vec> points;
  for (int i = 0; i < 200; ++i) points.push_back(random.noise(0.5));
  NetworkParts parts;
  parts.positions = points;
  parts.masses = {1};
  parts.start.assign(200, Vec{0, 0, 0});  // where it begins does not matter
  weft::ClothDesc cloth;
  cloth.collision_distance = 0.3;
  add_network(test, parts, cloth);
  EXPECT_EQ(excluded(test), offsets(0.15) + near_pairs_of(points, 0.3));

  cloth.collides_itself = 0;
  const weft::ClothId inert = add_network(test, parts, cloth);
  EXPECT_EQ(excluded(test), offsets(0.15) + near_pairs_of(points, 0.3));
  test.check(test.world().destroy_cloth(inert));

  desc.distance = 0.4;
  test.check(test.world().set_self_collision(desc));
  EXPECT_EQ(excluded(test), offsets(0.4) + near_pairs_of(points, 0.3)) << "its own counts";
  test.step(0.01);
  EXPECT_EQ(excluded(test), offsets(0.4) + near_pairs_of(points, 0.3));
  test.check(test.world().clear_self_collision());
  EXPECT_EQ(excluded(test), 0u);
}

TEST(SelfCollision, IsARemarkOnEachClothThatLeavesPairsOut) {
  TestWorld test;
  weft::GridDesc grid;
  grid.rows = grid.columns = 5;
  const weft::ClothId sheet = test.add(grid, {});
  const auto remarks = [&] { return test.take(test.world().diagnostics(sheet)); };
  EXPECT_EQ(remarks().count, 0u);
  SelfCollisionDesc desc;
  desc.distance = 0.3;
  test.check(test.world().set_self_collision(desc));
  ASSERT_EQ(remarks().count, 1u);
  const weft::Diagnostic told = remarks()[0];
  EXPECT_EQ(told.severity, weft::Severity::info);
  EXPECT_EQ(std::string(told.text).find("40 pairs of vertices are nearer"), 0u) << told.text;
  EXPECT_NE(std::string(told.text).find("0.3 m"), std::string::npos) << told.text;
  desc.distance = 0.2;
  test.check(test.world().set_self_collision(desc));
  EXPECT_EQ(remarks().count, 0u);
}

/// A pair by cloths in order of creation and their vertices.
using Quad = std::array<uint32_t, 4>;

struct Crowd {
  std::vector<weft::ClothId> ids;
  std::vector<std::vector<Vec>> rest, now;
  std::vector<weft::ClothSettings> settings;
};

/// By definition: of cloths that may meet, nearer than the mean of their distances.
std::vector<Quad> expected_pairs(const Crowd& crowd, double distance, bool with_excluded) {
  std::vector<Quad> found;
  const auto distance_of = [&](size_t c) {
    const double own = crowd.settings[c].collision_distance;
    return own > 0 ? own : distance;
  };
  for (uint32_t a = 0; a < crowd.ids.size(); ++a)
    for (uint32_t i = 0; i < crowd.now[a].size(); ++i)
      for (uint32_t b = a; b < crowd.ids.size(); ++b) {
        const weft::ClothSettings &one = crowd.settings[a], &two = crowd.settings[b];
        const double reach = 0.5 * (distance_of(a) + distance_of(b));
        const bool share = (one.collision_layers & two.collision_layers) != 0;
        const bool meet =
            a == b ? one.collides_itself != 0 : one.collides_others && two.collides_others && share;
        for (uint32_t j = a == b ? i + 1 : 0; meet && j < crowd.now[b].size(); ++j) {
          const Vec d = crowd.now[a][i] - crowd.now[b][j];
          if (!(dot(d, d) < reach * reach)) continue;
          const Vec r = crowd.rest[a][i] - crowd.rest[b][j];
          if (a == b && !with_excluded && dot(r, r) < reach * reach) continue;
          found.push_back({a, i, b, j});
        }
      }
  return found;
}

std::vector<Quad> found_pairs(TestWorld& test, const Crowd& crowd, bool with_excluded) {
  const weft::View<weft::NearPair> pairs = test.take(test.world().near_pairs(with_excluded));
  std::vector<Quad> found;
  const auto number = [&](weft::ClothId id) {
    return uint32_t(std::find(crowd.ids.begin(), crowd.ids.end(), id) - crowd.ids.begin());
  };
  for (uint32_t k = 0; k < pairs.count; ++k) {
    const weft::NearPair& p = pairs[k];
    found.push_back({number(p.cloth_a), p.vertex_a, number(p.cloth_b), p.vertex_b});
  }
  return found;
}

using Pairs = BothPrecisions;

/// Networks and grids far from the origin, crumpled, with every mixture of settings.
TEST_P(Pairs, AreThoseOfAllPairsAmongClothsThatMayMeet) {
  const Vec place{300, -200, 100};
  weft::WorldDesc desc = plain_world(GetParam());
  TestWorld test(desc);
  SelfCollisionDesc search;
  search.distance = 0.09;
  test.check(test.world().set_self_collision(search));
  reference::SplitMix random(11);
  Crowd crowd;
  for (uint32_t c = 0; c < 7; ++c) {
    weft::ClothDesc cloth;
    cloth.collision_distance = c % 3 == 1 ? 0.13 : 0;
    cloth.collides_itself = c != 2;
    cloth.collides_others = c != 5;
    cloth.collision_layers = c == 3 ? 2 : c == 4 ? 4 : c == 6 ? 6 : ~0u;
    std::vector<Vec> rest, now;
    for (uint32_t v = 0; v < 150; ++v) {
      rest.push_back({0.06 * (v % 15), 0.06 * (v / 15), 0});
      now.push_back(place + random.noise(0.3));
    }
    const std::vector<weft::double3> start = to_weft(now);
    if (c % 2 == 0) {
      weft::GridDesc grid;
      grid.rows = 10;
      grid.columns = 15;
      grid.width = 0.06 * 14;
      grid.height = 0.06 * 9;
      grid.material.stiffness = 1e-6;
      cloth.positions = weft::View<weft::double3>(start);
      crowd.ids.push_back(test.add(grid, cloth));
    } else {
      NetworkParts parts;
      parts.positions = rest;
      parts.start = now;
      parts.masses = {1e-3};
      crowd.ids.push_back(add_network(test, parts, cloth));
    }
    crowd.rest.push_back(rest);
    crowd.settings.push_back(cloth);
    crowd.now.push_back(now);
  }
  for (int n = 0; n < 3; ++n) {
    for (size_t c = 0; c < crowd.ids.size(); ++c) crowd.now[c] = test.positions(crowd.ids[c], 150);
    for (const bool with_excluded : {false, true}) {
      const std::vector<Quad> expected = expected_pairs(crowd, search.distance, with_excluded);
      EXPECT_EQ(found_pairs(test, crowd, with_excluded), expected) << n << " " << with_excluded;
      EXPECT_GT(expected.size(), 500u);
      if (!with_excluded) {
        EXPECT_EQ(test.take(test.world().contacts()).touching, expected.size());
      }
    }
    test.step(1.0 / 60);
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, Pairs, both_precisions(), precision_name);

TEST(SelfCollision, PairsAreAskedForWhereThereIsASearch) {
  TestWorld test;
  add_particles(test, {{0, 0, 0}, {0.001, 0, 0}});
  expect_refusal(test, test.world().near_pairs().status(), {"set_self_collision"});
  const weft::ContactCounts none = test.take(test.world().contacts());
  EXPECT_EQ(none.touching + none.excluded + none.listed + none.lists, 0u);
}

}  // namespace
}  // namespace weft_tests::self_collision
