// Whom colliders wake that turn, and that no list of near ones changes a bit.
#include "reference/turning.h"

namespace weft_tests::turning_sleep {
namespace {

constexpr double dt = 1.0 / 64;

/// A sheet at rest that sleeps, and colliders that turn in and out of its reach.
class TurningAndSleep : public testing::TestWithParam<double> {
 protected:
  TurningAndSleep() : test(still()), id(add_sheet(test)) {}
  static weft::ClothId add_sheet(TestWorld& test) {
    weft::GridDesc grid;
    grid.rows = grid.columns = 9;
    const std::vector<weft::Pin> pins{{0}, {8}, {72}, {80}};
    weft::ClothDesc cloth;
    cloth.pins = pins;
    cloth.pose.translate = {GetParam() - 0.5, -0.5, 0};
    cloth.sleep_speed = 0.01;
    cloth.sleep_time = 0.1;
    return test.add(grid, cloth);
  }
  static weft::WorldDesc still() {
    weft::WorldDesc desc;
    desc.gravity = {0, 0, 0};
    return desc;
  }
  bool asleep() { return test.take(test.world().asleep(id)); }
  TestWorld test;
  weft::ClothId id;
};

TEST_P(TurningAndSleep, WhatTurnsOutOfReachWakesNobody) {
  const Vec place{GetParam(), 0, 0};
  std::vector<weft::ColliderId> far;
  for (const Body body : every_body) far.push_back(add_body(test, body, place - Vec{0, 3, 0}, 0.3));
  test.step(dt, 20);
  ASSERT_TRUE(asleep());
  for (int n = 1; n <= 40; ++n) {
    for (const weft::ColliderId collider : far)
      test.check(test.world().move_collider(
          collider, about(place - Vec{0, 3.3, 0}, {0, 0, 0}, {1, 0, 1}, 2.0 * (n % 5))));
    test.step(dt);
    ASSERT_TRUE(asleep()) << n;
  }
}

TEST_P(TurningAndSleep, WhatTurnsIntoItWakesItAndEqualInputDoesNot) {
  const Vec place{GetParam(), 0, 0};
  for (const Body body : every_body) {
    if (body == Body::sphere) continue;  // turns into itself
    SCOPED_TRACE(name(body));
    TestWorld fresh(still());
    const weft::ClothId sheet = add_sheet(fresh);
    const auto sleeps = [&] { return fresh.take(fresh.world().asleep(sheet)); };
    // Below the sheet's plane z = 0 until a quarter of a turn brings it up.
    const Vec middle = place + Vec{0, 0, -0.3};
    const weft::ColliderId one = add_body(fresh, body, middle + Vec{0, 0.28, 0}, 0.28);
    const weft::Pose away = about(middle, {0, 0, -0.2}, {0, 0, 1}, 0);
    if (body == Body::plane) {
      fresh.check(fresh.world().move_collider(one, about(place, {0, -9, 0}, {0, 0, 1}, 0),
                                              weft::Move::teleport));
    } else {
      fresh.check(fresh.world().move_collider(one, away, weft::Move::teleport));
    }
    fresh.step(dt, 30);
    ASSERT_TRUE(sleeps());
    const weft::Pose still = body == Body::plane ? about(place, {0, -9, 0}, {0, 0, 1}, 0) : away;
    for (int n = 0; n < 3; ++n) {
      fresh.check(fresh.world().move_collider(one, still));
      fresh.step(dt);
      EXPECT_TRUE(sleeps()) << "equal input";
    }
    const weft::Pose up = body == Body::plane ? about(place, {0, -9, 0}, {0, 0, 1}, 170)
                                              : about(middle, {0, 0, 0.1}, {0, 1, 0}, 80);
    fresh.check(fresh.world().move_collider(one, up));
    fresh.step(dt);
    EXPECT_FALSE(sleeps());
  }
}

TEST_P(TurningAndSleep, ASetThatIsSentAgainWakesNobodyAndASizeThatReachesItDoes) {
  const Vec place{GetParam(), 0, -0.4};
  const auto set = test.take(test.world().create_collider_set(Limbs(place, 33, true).desc()));
  test.step(dt, 20);
  const Limbs turned_on(place, 47, true);
  weft::ColliderSetDesc sent = turned_on.desc();
  sent.may_stretch = true;  // in float each bone has another length
  test.check(test.world().move_collider_set(set, sent));
  test.step(dt, 20);
  ASSERT_TRUE(asleep());
  for (const bool may_stretch : {false, true, false}) {
    const Limbs same(place, 47, true);
    weft::ColliderSetDesc desc = same.desc();
    desc.may_stretch = may_stretch;
    test.check(test.world().move_collider_set(set, desc));
    test.step(dt);
    EXPECT_TRUE(asleep());
  }
  const Limbs large(place, 47, true, 3);
  weft::ColliderSetDesc desc = large.desc();
  desc.may_stretch = true;
  test.check(test.world().move_collider_set(set, desc));
  EXPECT_FALSE(asleep());
}

INSTANTIATE_TEST_SUITE_P(At, TurningAndSleep, testing::Values(0.0, 5000.0, 1e5));

/// Beyond the 64 entries of a block's mask, and out of reach: what is left out never changes a bit.
TEST(TurningLists, WhatTurnsOutOfReachChangesNoBit) {
  for (const auto precision : {weft::Precision::float32, weft::Precision::float64})
    for (const auto form : {weft::Form::summed, weft::Form::position}) {
      weft::WorldDesc desc;
      desc.precision = precision;
      desc.form = form;
      desc.substeps = 24;
      TestWorld few(desc), many(desc);
      weft::GridDesc grid;
      grid.rows = 19;
      grid.columns = 21;
      const std::vector<weft::Pin> pins{{0}, {20}};
      weft::ClothDesc cloth;
      cloth.pins = pins;
      const weft::ClothId a = few.add(grid, cloth), b = many.add(grid, cloth);
      std::vector<std::pair<weft::ColliderId, weft::ColliderId>> near;
      std::vector<weft::ColliderId> far;
      for (const Body body : every_body) {
        for (int i = 0; i < 12; ++i)
          far.push_back(add_body(many, body, {8.0 + 3 * i, -1.5 * i - 8, 4}, 0.3));
        const Vec at{0.1 * int(body), 0.1 + 0.1 * int(body), 0.3};
        const Vec top = body == Body::plane ? Vec{0, -0.7, 0} : at;
        near.emplace_back(add_body(few, body, top, 0.12, 0.3),
                          add_body(many, body, top, 0.12, 0.3));
      }
      for (int n = 1; n <= 40; ++n) {
        const auto turn = [&](Vec at) { return about(at, {0, 0, -0.01 * n}, {1, 1, 3}, 9.0 * n); };
        int i = 0;
        for (const auto& [c, d] : near) {
          const Vec at = i == int(Body::plane) ? Vec{0, -0.7, 0} : Vec{0.1 * i, 0.1 * i, 0.3};
          const weft::Pose pose =
              i == int(Body::plane) ? about(at, {0, 0, 0}, {1, 0, 0}, 2.0 * (n % 3)) : turn(at);
          ++i;
          few.check(few.world().move_collider(c, pose));
          many.check(many.world().move_collider(d, pose));
        }
        for (size_t k = 0; k < far.size(); ++k) {
          if (k / 12 == size_t(Body::plane)) continue;
          many.check(many.world().move_collider(far[k], turn({30, 0, 0})));
        }
        few.step(1.0 / 60);
        many.step(1.0 / 60);
        const std::vector<Vec> x = few.positions(a), y = many.positions(b);
        for (size_t v = 0; v < x.size(); ++v) ASSERT_TRUE(same_bits(x[v], y[v])) << n << " " << v;
      }
    }
}

}  // namespace
}  // namespace weft_tests::turning_sleep
