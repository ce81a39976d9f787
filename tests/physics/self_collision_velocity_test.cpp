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

/// Ten particles one above the other on the ground: what presses on the lowest is ten times what
/// presses on the highest. They stand still, and are said to. A computation of the formula along a
/// line has them at 0.977 of their distances and says 0.041 m/s. (Without overlaps that begin an
/// impulse it has 0.45 of them and 0.45 m/s.)
TEST_P(SelfCollisionVelocity, AColumnRests) {
  const double distance = 0.008;
  const uint32_t count = 10;
  TestWorld test(world({0, -9.81, 0}, 18));
  let_meet(test, distance, 0.3);
  add_body(test, Body::plane, {}, 1);
  NetworkParts parts;
  for (uint32_t i = 0; i < count; ++i) {
    parts.positions.push_back({double(i), 0, 0});  // none is excluded
    parts.start.push_back({0.1, i * distance, -0.2});
    parts.masses.push_back(1e-3);
  }
  const weft::ClothId column = add_network(test, parts);
  test.step(dt, 120);
  const std::vector<Vec> x = test.positions(column, count), v = test.velocities(column, count);
  test.step(dt, 60);
  const std::vector<Vec> later = test.positions(column, count);
  for (uint32_t i = 0; i < count; ++i) {
    const double gap = i > 0 ? length(x[i] - x[i - 1]) : distance;
    EXPECT_GE(gap, 0.97 * distance) << i;
    EXPECT_LE(length(v[i]), 0.05) << i;
    EXPECT_LE(length(later[i] - x[i]), 1e-4) << i;
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
