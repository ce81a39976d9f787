// Particles at one place, and pairs that rest too near to touch.
#include "reference/effects.h"
#include "reference/random.h"

#include <chrono>
#include <tuple>

namespace weft_tests::self_collision_degenerate {
namespace {

constexpr double dt = 1.0 / 60;

class SelfCollisionDegenerate
    : public testing::TestWithParam<std::tuple<weft::Precision, weft::Form>> {
 protected:
  weft::WorldDesc world() const {
    weft::WorldDesc desc = plain_world(std::get<0>(GetParam()));
    desc.form = std::get<1>(GetParam());
    return desc;
  }
  bool wide() const { return std::get<0>(GetParam()) == weft::Precision::float64; }
};

weft::SelfCollisionDesc within(double distance) {
  weft::SelfCollisionDesc desc;
  desc.distance = distance;
  desc.cell = 2 * distance;
  return desc;
}

/// Particles 1 m apart at rest that all begin at `start`.
weft::ClothId add_heap(TestWorld& test, uint32_t count, Vec start, double last_mass = 1) {
  NetworkParts parts;
  for (uint32_t i = 0; i < count; ++i) parts.positions.push_back({double(i), 0, 0});
  parts.start.assign(count, start);
  parts.masses.assign(count, 1);
  parts.masses.back() = last_mass;
  return add_network(test, parts);
}

TEST_P(SelfCollisionDegenerate, TwoAtOnePlaceGetToTheDistanceAndNoSpeed) {
  for (const Vec at : {Vec{0, 0, 0}, Vec{0.3, -0.7, 2}}) {
    std::vector<Vec> x[2];
    for (std::vector<Vec>& run : x) {
      TestWorld test(world());
      test.check(test.world().set_self_collision(within(0.125)));
      const weft::ClothId cloth = add_heap(test, 2, at, 3);
      test.step(dt);
      run = test.positions(cloth, 2);
      EXPECT_NEAR(length(run[1] - run[0]), 0.125, 1e-6);
      // Shared by the masses, 1 and 3.
      expect_near(0.25 * run[0] + 0.75 * run[1], at, 1e-6);
      EXPECT_NEAR(length(run[0] - at), 0.75 * 0.125, 1e-6);
      EXPECT_LE(test.mechanics().kinetic, 1e-10);
      test.step(dt, 10);
      expect_near(test.positions(cloth, 2)[1], run[1], 1e-5);
    }
    for (size_t i = 0; i < 2; ++i) EXPECT_TRUE(same_bits(x[0][i], x[1][i]));
  }
}

/// In a few substeps, with their momentum and with less than a distance's worth of speed.
TEST_P(SelfCollisionDegenerate, ManyAtOnePlaceSeparate) {
  for (const weft::PairSearch search : {weft::PairSearch::complete, weft::PairSearch::staggered}) {
    TestWorld test(world());
    weft::SelfCollisionDesc desc = within(0.125);
    desc.search = search;
    test.check(test.world().set_self_collision(desc));
    const Vec at{0.5, 0.25, -0.5};
    const uint32_t count = 60;
    const weft::ClothId cloth = add_heap(test, count, at);
    EXPECT_EQ(test.take(test.world().contacts()).touching, count * (count - 1) / 2);
    test.step(dt, 400);
    const std::vector<Vec> x = test.positions(cloth, count);
    ASSERT_TRUE(all_finite(x));
    Vec sum;
    double least = 1;
    for (uint32_t i = 0; i < count; ++i) {
      sum += x[i] - at;
      for (uint32_t j = 0; j < i; ++j) least = std::min(least, length(x[i] - x[j]));
    }
    EXPECT_GE(least, 0.95 * 0.125);
    // The position form rounds a displacement at the size of the position, eight times a substep,
    // and goes on with it: 60 * 8 * 3e-8 m, times some 400^1.5 / 2 at random.
    const double rounds = world().form == weft::Form::position ? 0.057 : 1e-3;
    EXPECT_LE(length(sum), wide() ? 1e-11 : rounds) << "the centre of mass stays";
    // That is 60 * 8 * 3e-8 m in each, 400^0.5 times at random, in a 64th of a second.
    const double momentum = world().form == weft::Form::position ? 0.018 : 1e-2;
    EXPECT_LE(length(from_weft(test.mechanics().momentum)), wide() ? 1e-11 : momentum);
    EXPECT_LE(test.mechanics().kinetic, 1e-6 * count) << "an overlap gives speed";
  }
}

/// A cloth all of whose vertices begin in one point: the whole of its pairs, in bounded time, and
/// the same again on other threads.
TEST(SelfCollisionOfAPoint, FiveThousandVerticesBegin) {
  uint64_t hashes[2];
  for (const uint32_t threads : {1u, 2u}) {
    weft::WorldDesc world;
    world.substeps = 1;
    weft::ContextDesc context = TestWorld::one_thread();
    context.threads = threads;
    TestWorld test(world, context);
    weft::SelfCollisionDesc desc = within(0.01);
    desc.skin = threads == 1 ? -1 : 0;
    test.check(test.world().set_self_collision(desc));
    const weft::ClothId cloth = add_heap(test, 5000, {1, 2, 3});
    const auto begin = std::chrono::steady_clock::now();
    test.step(dt);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(took.count(), 20);
    EXPECT_GE(test.take(test.world().contacts()).listed, 12497500u) << "all are held";
    const std::vector<Vec> x = test.positions(cloth, 5000);
    ASSERT_TRUE(all_finite(x));
    size_t moved = 0;
    for (const Vec& p : x) moved += length(p - Vec{1, 2 - 9.81 / 2 * dt * dt, 3}) > 1e-6;
    EXPECT_GT(moved, 4900u);
    hashes[threads - 1] = test.hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

/// A sheet whose neighbours are nearer than the distance rests as if there were no contact: every
/// pair that could touch is excluded. With its edges, its diagonals, or more.
TEST_P(SelfCollisionDegenerate, PairsThatRestNearerNeverTouch) {
  for (const double distance : {0.11, 0.15, 0.24}) {
    uint64_t hashes[2];
    uint64_t excluded = 0;
    for (const bool with : {false, true}) {
      TestWorld test(world());
      if (with) test.check(test.world().set_self_collision(within(distance)));
      weft::GridDesc grid;
      grid.rows = 11;
      grid.columns = 6;
      grid.height = 1;
      grid.width = 0.5;
      grid.material.stiffness = 4;
      weft::ClothDesc cloth;
      cloth.pose = {{1, 2, 3}, 30, {0.1, 0.2, 0.3}};
      cloth.velocity = {0.1, 0, 0};
      test.add(grid, cloth);
      test.step(dt, 20);
      hashes[with] = test.hash();
      if (with) excluded = test.take(test.world().contacts()).excluded;
    }
    EXPECT_EQ(hashes[0], hashes[1]) << distance;
    uint64_t expected = 0;
    for (int r = 0; r < 11; ++r)
      for (int c = -5; c < 6; ++c) {
        if (r == 0 && c <= 0) continue;
        if (0.1 * std::hypot(r, c) < distance) expected += uint64_t((11 - r) * (6 - std::abs(c)));
      }
    EXPECT_EQ(excluded, expected) << distance;
  }
}

/// At exactly the distance at rest a pair is not excluded, and nothing touches either.
TEST_P(SelfCollisionDegenerate, APairThatRestsAtTheDistanceMeets) {
  for (const double rest : {0.125, 0.1249}) {
    TestWorld test(world());
    test.check(test.world().set_self_collision(within(0.125)));
    NetworkParts parts;
    parts.positions = {{0, 0, 0}, {rest, 0, 0}};
    parts.start = {{0, 0, 0}, {0, 0.1, 0}};
    parts.masses = {1};
    const weft::ClothId cloth = add_network(test, parts);
    const bool meets = rest == 0.125;
    EXPECT_EQ(test.take(test.world().contacts()).excluded, meets ? 0u : 1u);
    test.step(dt);
    const std::vector<Vec> x = test.positions(cloth, 2);
    EXPECT_NEAR(length(x[1] - x[0]), meets ? 0.125 : 0.1, 1e-6);
  }
}

/// What two cloths have at rest says nothing about where they may be.
TEST_P(SelfCollisionDegenerate, OtherClothsAreNeverExcluded) {
  TestWorld test(world());
  test.check(test.world().set_self_collision(within(0.125)));
  const weft::ClothId cloths[] = {add_particles(test, {{0, 0, 0}}),
                                  add_particles(test, {{0, 0.05, 0}})};
  EXPECT_EQ(test.take(test.world().contacts()).excluded, 0u);
  EXPECT_EQ(test.take(test.world().contacts()).touching, 1u);
  test.step(dt);
  EXPECT_NEAR(test.positions(cloths[0], 1)[0].y, -0.0375, 1e-7);
  EXPECT_NEAR(test.positions(cloths[1], 1)[0].y, 0.0875, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Every, SelfCollisionDegenerate,
                         testing::Combine(both_precisions(), testing::Values(weft::Form::summed,
                                                                             weft::Form::position)),
                         [](const auto& info) {
                           return std::string(weft::to_string(std::get<0>(info.param))) +
                                  (std::get<1>(info.param) == weft::Form::summed ? "_summed"
                                                                                 : "_position");
                         });

}  // namespace
}  // namespace weft_tests::self_collision_degenerate
