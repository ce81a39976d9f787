// A sleeper whose support leaves wakes.
#include "reference/effects.h"

#include <tuple>

namespace weft_tests::self_collision_leaving {
namespace {

constexpr double dt = 1.0 / 60;

class SelfCollisionLeaving
    : public testing::TestWithParam<std::tuple<weft::Precision, weft::Form>> {
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

/// What a sleeper lies on goes away: it wakes and falls.
TEST_P(SelfCollisionLeaving, ASleeperWakesWhenWhatBearsItLeaves) {
  for (const bool destroyed : {true, false}) {
    TestWorld test(world({0, -9.81, 0}, 4));
    let_meet(test, 0.1);
    NetworkParts parts;
    parts.positions = {{0, 0, 0}};
    parts.masses = {1};
    parts.pins = {0};
    const weft::ClothId low = add_network(test, parts);
    const weft::ClothId high = add_one(test, {0, 0.1, 0}, sleeper());
    test.step(dt, 30);
    ASSERT_TRUE(asleep(test, high));
    EXPECT_NEAR(at(test, high).y, 0.1, 1e-3);
    if (destroyed) {
      test.check(test.world().destroy_cloth(low));
    } else {
      test.check(test.world().clear_self_collision());
    }
    test.step(dt, 12);
    EXPECT_FALSE(asleep(test, high)) << destroyed;
    EXPECT_LT(at(test, high).y, 0.02) << destroyed;
  }
}

/// A pin below that is led away, or moved, or let go takes the support with it.
TEST_P(SelfCollisionLeaving, ASleeperWakesWhenItsSupportIsMoved) {
  for (const int way : {0, 1, 2}) {
    TestWorld test(world({0, -9.81, 0}, 4));
    let_meet(test, 0.1);
    NetworkParts parts;
    parts.positions = {{0, 0, 0}};
    parts.masses = {1};
    parts.pins = {0};
    const weft::ClothId low = add_network(test, parts);
    const weft::ClothId high = add_one(test, {0, 0.1, 0}, sleeper());
    test.step(dt, 30);
    ASSERT_TRUE(asleep(test, high));
    const uint32_t vertex = 0;
    const std::vector<weft::double3> target{way == 0 ? weft::double3{0, 0.05, 0}
                                                     : weft::double3{0, -0.3, 0}};
    const weft::View<uint32_t> vertices(&vertex, 1);
    if (way == 2) {
      test.check(test.world().release_pins(low, vertices));
    } else {
      test.check(test.world().move_pins(low, vertices, weft::View<weft::double3>(target)));
    }
    test.step(dt, 12);
    EXPECT_FALSE(asleep(test, high)) << "way " << way;
    EXPECT_GT(std::abs(at(test, high).y - 0.1), 0.04) << "way " << way;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, SelfCollisionLeaving,
                         testing::Combine(both_precisions(), testing::Values(weft::Form::summed,
                                                                             weft::Form::position)),
                         [](const auto& info) {
                           return std::string(weft::to_string(std::get<0>(info.param))) +
                                  (std::get<1>(info.param) == weft::Form::summed ? "_summed"
                                                                                 : "_position");
                         });

}  // namespace
}  // namespace weft_tests::self_collision_leaving
