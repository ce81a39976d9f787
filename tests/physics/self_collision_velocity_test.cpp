// What read_velocities says where one cloth lies on another.
#include "reference/effects.h"

#include <tuple>

namespace weft_tests::self_collision_velocity {
namespace {

constexpr double dt = 1.0 / 60;

class SelfCollisionVelocity
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

/// Its velocity is 0, not that of half a substep's fall.
TEST_P(SelfCollisionVelocity, WhatRestsOnAClothHasNone) {
  for (const bool collider : {false, true})
    for (const uint32_t substeps : {1u, 5u}) {
      SCOPED_TRACE(testing::Message() << collider << " " << substeps);
      TestWorld test(world({0, -9.81, 0}, substeps));
      let_meet(test, 0.1);
      if (collider) add_body(test, Body::plane, {0, -5, 0}, 1);
      NetworkParts parts;
      parts.positions = {{0.2, 0.3, -0.1}};
      parts.masses = {1};
      parts.pins = {0};
      add_network(test, parts);
      const weft::ClothId high = add_one(test, {0.2, 0.4001, -0.1});
      test.step(dt, 30);
      const double half_fall = 0.5 * 9.81 * dt / substeps;
      EXPECT_LE(length(test.velocities(high, 1)[0]), 0.05 * half_fall);
      EXPECT_LE(test.mechanics().kinetic, 0.01 * half_fall * half_fall);
    }
}

INSTANTIATE_TEST_SUITE_P(Every, SelfCollisionVelocity,
                         testing::Combine(both_precisions(), testing::Values(weft::Form::summed,
                                                                             weft::Form::position)),
                         [](const auto& info) {
                           return std::string(weft::to_string(std::get<0>(info.param))) +
                                  (std::get<1>(info.param) == weft::Form::summed ? "_summed"
                                                                                 : "_position");
                         });

}  // namespace
}  // namespace weft_tests::self_collision_velocity
