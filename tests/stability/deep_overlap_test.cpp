// Particles that start deep inside a collider (HC44, HC46).
#include "reference/effects.h"

namespace weft_tests::deep_overlap {
namespace {

using DeepOverlap = BothPrecisions;

constexpr double dt = 1.0 / 60;

TEST_P(DeepOverlap, WhatStartsDeepInsideLeavesNoFasterThanItCame) {
  const Vec top{0.25, 0.5, -0.125};
  const double size = 0.1;
  for (const Body body : every_body)
    for (const double depth : {0.02, 0.05, 0.1})
      for (const Vec velocity : {Vec{}, Vec{0, 0.3, 0}, Vec{0, -0.3, 0}, Vec{0.3, 0, 0}}) {
        SCOPED_TRACE(testing::Message()
                     << name(body) << " " << depth << " " << velocity.x << " " << velocity.y);
        TestWorld test(plain_world(GetParam(), weft::Start::lagged));
        const weft::ClothId cloth = add_particles(test, {top - Vec{0, depth, 0}}, velocity);
        add_body(test, body, top, size);
        test.step(dt);
        const Vec before = test.position(cloth, 0);
        test.step(dt);
        const double speed = length(test.position(cloth, 0) - before) / dt;
        EXPECT_LE(speed, length(velocity) + 1e-4);
      }
}

/// The way out is not gone on with either where the next step has another length: it is taken back
/// as the recurrence of a changed step would go on with it.
TEST_P(DeepOverlap, NoStepOfAnotherLengthGoesOnWithTheWayOut) {
  const Vec top{0.25, 0.5, -0.125};
  for (const weft::Form form : {weft::Form::summed, weft::Form::position})
    for (const Body body : every_body)
      for (const double next : {0.25, 0.5, 2.0, 4.0}) {
        SCOPED_TRACE(testing::Message() << name(body) << ", form " << int(form) << " " << next);
        weft::WorldDesc desc = plain_world(GetParam(), weft::Start::lagged);
        desc.form = form;
        TestWorld test(desc);
        const weft::ClothId cloth = add_particles(test, {top - Vec{0, 0.04, 0}});
        add_body(test, body, top, 0.1);
        test.step(dt);
        expect_near(test.position(cloth, 0), top, 1e-6);
        test.step(next * dt);
        expect_near(test.position(cloth, 0), top, 1e-5);
        test.step(dt, 3);
        expect_near(test.position(cloth, 0), top, 1e-4);
      }
}

/// One step of a resting particle on the axis of a body about `middle`; true if that got it out.
template <class Create>
bool leaves_from_axis(weft::Precision precision, Vec at, double radius, Create create) {
  TestWorld test(plain_world(precision));
  const weft::ClothId cloth = add_particles(test, {at});
  create(test);
  test.step(dt);
  const Vec from = test.position(cloth, 0) - at;
  const double across_axis = length(from - dot(from, beside) * beside);
  return std::abs(across_axis - radius) < 1e-5;
}

TEST_P(DeepOverlap, OnTheAxisUpToRoundingTheWayOutIsAcrossIt) {
  const Vec middle{0.25, 0.4, -0.125};
  const double radius = 0.1, half = 0.5;
  int stuck_in_capsule = 0, stuck_in_cylinder = 0;
  for (int i = -9; i <= 9; ++i) {
    const Vec at = middle + 0.02 * i * beside;
    stuck_in_capsule += !leaves_from_axis(GetParam(), at, radius, [&](TestWorld& test) {
      weft::CapsuleDesc capsule;
      capsule.a = to_weft(middle - half * beside);
      capsule.b = to_weft(middle + half * beside);
      capsule.radius = radius;
      test.take(test.world().create_capsule(capsule));
    });
    stuck_in_cylinder += !leaves_from_axis(GetParam(), at, radius, [&](TestWorld& test) {
      weft::CylinderDesc cylinder;
      cylinder.a = to_weft(middle - half * beside);
      cylinder.b = to_weft(middle + half * beside);
      cylinder.radius = radius;
      test.take(test.world().create_cylinder(cylinder));
    });
  }
  EXPECT_EQ(stuck_in_capsule, 0);
  EXPECT_EQ(stuck_in_cylinder, 0);
}

INSTANTIATE_TEST_SUITE_P(Precision, DeepOverlap, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::deep_overlap
