// Cloths that meet each other: who meets whom, who wakes whom, and what lies on what.
#include "reference/effects.h"

#include <tuple>

namespace weft_tests::self_collision_cloths {
namespace {

constexpr double dt = 1.0 / 60;

class SelfCollisionCloths : public testing::TestWithParam<std::tuple<weft::Precision, weft::Form>> {
 protected:
  weft::WorldDesc world(weft::double3 gravity = {0, 0, 0}, uint32_t substeps = 1) const {
    weft::WorldDesc desc = plain_world(std::get<0>(GetParam()));
    desc.form = std::get<1>(GetParam());
    desc.gravity = gravity;
    desc.substeps = substeps;
    return desc;
  }
};

void let_meet(TestWorld& test, double distance, double friction = 0) {
  weft::SelfCollisionDesc desc;
  desc.distance = distance;
  desc.friction = friction;
  test.check(test.world().set_self_collision(desc));
}

/// One particle; asleep as soon as it may where `sleeps`.
weft::ClothId add_one(TestWorld& test, Vec at, weft::ClothDesc desc = {}, double mass = 1) {
  const std::vector<weft::double3> x{to_weft(at)};
  weft::NetworkDesc network;
  network.positions = weft::View<weft::double3>(x);
  network.material.mass.value = mass;
  return test.add(network, desc);
}
weft::ClothDesc sleeper() {
  weft::ClothDesc desc;
  desc.sleep_speed = 0.05;
  desc.sleep_time = 0.1;
  return desc;
}
Vec at(TestWorld& test, weft::ClothId cloth) { return test.positions(cloth, 1)[0]; }
bool asleep(TestWorld& test, weft::ClothId cloth) { return test.take(test.world().asleep(cloth)); }

/// Of two cloths of distances 0.1 and 0.3 the pairs are nearer than 0.2.
TEST_P(SelfCollisionCloths, APairTakesTheMeanOfItsDistances) {
  for (const double apart : {0.15, 0.19, 0.21}) {
    TestWorld test(world());
    let_meet(test, 0.1);
    weft::ClothDesc thick;
    thick.collision_distance = 0.3;
    const weft::ClothId a = add_one(test, {0, 0, 0}), b = add_one(test, {apart, 0, 0}, thick);
    test.step(dt, 2);
    EXPECT_NEAR(at(test, b).x - at(test, a).x, std::max(0.2, apart), 1e-6);
  }
}

TEST_P(SelfCollisionCloths, LayersAndSwitchesSayWhoMeets) {
  const struct {
    uint32_t layers[2];
    uint8_t others[2];
    bool meet;
  } cases[] = {{{1, 1}, {1, 1}, true},      {{1, 2}, {1, 1}, false},
               {{6, 5}, {1, 1}, true},      {{0x80000000, 0x80000001}, {1, 1}, true},
               {{~0u, ~0u}, {0, 1}, false}, {{~0u, ~0u}, {1, 0}, false},
               {{~0u, 0}, {1, 1}, false},   {{0x40000000, 0x80000000}, {1, 1}, false}};
  for (const auto& c : cases) {
    TestWorld test(world());
    let_meet(test, 0.1);
    weft::ClothId id[2];
    for (int k = 0; k < 2; ++k) {
      weft::ClothDesc desc;
      desc.collision_layers = c.layers[k];
      desc.collides_others = c.others[k];
      id[k] = add_one(test, {0, 0.05 * k, 0}, desc);
    }
    EXPECT_EQ(test.take(test.world().contacts()).touching, c.meet ? 1u : 0u);
    test.step(dt);
    EXPECT_EQ(at(test, id[1]).y - at(test, id[0]).y > 0.09, c.meet)
        << c.layers[0] << " " << c.layers[1];
  }
}

/// A cloth without layers still meets itself, unless it does not meet itself.
TEST_P(SelfCollisionCloths, MeetingItselfHasItsOwnSwitch) {
  for (const uint8_t itself : {uint8_t(0), uint8_t(1)}) {
    TestWorld test(world());
    let_meet(test, 0.1);
    NetworkParts parts;
    parts.positions = {{0, 0, 0}, {1, 0, 0}};
    parts.start = {{0, 0, 0}, {0.05, 0, 0}};
    parts.masses = {1};
    weft::ClothDesc desc;
    desc.collides_itself = itself;
    desc.collision_layers = 0;
    desc.collides_others = 0;
    const weft::ClothId cloth = add_network(test, parts, desc);
    test.step(dt);
    EXPECT_NEAR(length(test.positions(cloth, 2)[1] - test.positions(cloth, 2)[0]),
                itself ? 0.1 : 0.05, 1e-6);
  }
}

TEST_P(SelfCollisionCloths, ASleeperWakesByWhatMovesNotByWhatRests) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double speed : {0.0, 0.02, 0.4, -0.4}) {
      TestWorld test(world());
      let_meet(test, 0.1);
      const weft::ClothId a = add_one(test, {0, 0, 0}, sleeper());
      test.step(dt, 12);
      ASSERT_TRUE(asleep(test, a));
      weft::ClothDesc moving;
      const Vec side = axis == 0 ? Vec{1, 0, 0} : axis == 1 ? Vec{0, 1, 0} : Vec{0, 0, 1};
      moving.velocity = to_weft(-speed * side);
      const double gap = speed == 0 ? 0.09 : 0.1 + 2.5 * dt * std::abs(speed);
      const weft::ClothId b = add_one(test, (speed < 0 ? -gap : gap) * side, moving);
      test.step(dt, 6);
      const bool wakes = std::abs(speed) > 0.05;
      EXPECT_EQ(!asleep(test, a), wakes) << speed << " along " << axis;
      if (!wakes) {
        EXPECT_EQ(length(at(test, a)), 0) << "a sleeper stands";
        EXPECT_GE(length(at(test, b)), 0.1 - 1e-6) << "and holds others off";
      }
    }
}

/// Two sheets on the floor: both come to rest on each other and go to sleep.
TEST_P(SelfCollisionCloths, AStackFallsAsleep) {
  TestWorld test(world({0, -9.81, 0}, 8));
  let_meet(test, 0.02, 0.4);
  add_body(test, Body::plane, {0, 0, 0}, 1, 0.5);
  weft::GridDesc grid;
  grid.rows = grid.columns = 7;
  grid.width = grid.height = 0.18;
  grid.material.stiffness = 10;
  grid.material.mass.value = 0.05;
  weft::ClothId id[2];
  for (int k = 0; k < 2; ++k) {
    weft::ClothDesc desc = sleeper();
    desc.drag = 1e-3;
    desc.pose = {{1, 0, 0}, 90, {0.004 * k, 0.002 + 0.025 * k, 0.003 * k}};
    id[k] = test.add(grid, desc);
  }
  test.step(dt, 150);
  EXPECT_TRUE(asleep(test, id[0]));
  EXPECT_TRUE(asleep(test, id[1]));
}

/// What a sleeper lies on stops pushing: it wakes and falls.
TEST_P(SelfCollisionCloths, ASleeperWakesWhenContactIsCleared) {
  TestWorld test(world({0, -9.81, 0}, 4));
  let_meet(test, 0.1);
  NetworkParts parts;
  parts.positions = {{0, 0, 0}};
  parts.masses = {1};
  parts.pins = {0};
  add_network(test, parts);
  const weft::ClothId high = add_one(test, {0, 0.1, 0}, sleeper());
  test.step(dt, 30);
  ASSERT_TRUE(asleep(test, high));
  EXPECT_NEAR(at(test, high).y, 0.1, 1e-3);
  test.check(test.world().clear_self_collision());
  test.step(dt, 12);
  EXPECT_FALSE(asleep(test, high));
  EXPECT_LT(at(test, high).y, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Every, SelfCollisionCloths,
                         testing::Combine(both_precisions(), testing::Values(weft::Form::summed,
                                                                             weft::Form::position)),
                         [](const auto& info) {
                           return std::string(weft::to_string(std::get<0>(info.param))) +
                                  (std::get<1>(info.param) == weft::Form::summed ? "_summed"
                                                                                 : "_position");
                         });

}  // namespace
}  // namespace weft_tests::self_collision_cloths
