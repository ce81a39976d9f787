// move_collider: what a collider carries on its way to a pose, and what a teleport leaves alone
// (HC51, HC55).
#include "reference/effects.h"
#include "reference/refusals.h"

#include <limits>

namespace weft_tests::collider_motion {
namespace {

using ColliderMotion = BothPrecisions;

constexpr double dt = 1.0 / 60;
constexpr Vec top{0.25, 0.5, -0.125};

weft::WorldDesc heavy(weft::Precision precision, uint32_t substeps) {
  weft::WorldDesc desc = plain_world(precision);
  desc.gravity = {0, -9.81, 0};
  desc.substeps = substeps;
  return desc;
}
weft::Pose shift(Vec by) { return {{1, 0, 0}, 0, to_weft(by)}; }

TEST_P(ColliderMotion, ALiftCarriesWhatRestsOnItByPosesAsByVelocity) {
  const double speed = 0.5;
  for (const Body body : every_body)
    for (const uint32_t substeps : {1u, 8u})
      for (const bool by_pose : {false, true}) {
        SCOPED_TRACE(testing::Message() << name(body) << " " << substeps << " " << by_pose);
        TestWorld test(heavy(GetParam(), substeps));
        const weft::ClothId cloth = add_particles(test, {top});
        const weft::ColliderId id =
            add_body(test, body, top, 0.2, 0.5, by_pose ? Vec{} : Vec{0, speed, 0});
        for (int n = 1; n <= 60; ++n) {
          const Vec by{0, speed * n * dt, 0};
          if (by_pose) test.check(test.world().move_collider(id, shift(by)));
          test.step(dt);
          ASSERT_LE(length(test.position(cloth, 0) - (top + by)), tolerance(GetParam(), 1)) << n;
        }
      }
}

TEST_P(ColliderMotion, WhatSticksIsWhereThePoseSaysAtTheEndOfEveryStep) {
  const Vec velocity{0.06, 0.03, -0.02};  // little enough to stick from the first substep on
  for (const Body body : every_body)
    for (const uint32_t substeps : {1u, 8u}) {
      SCOPED_TRACE(testing::Message() << name(body) << " " << substeps);
      TestWorld test(heavy(GetParam(), substeps));
      const weft::ClothId cloth = add_particles(test, {top});
      const weft::ColliderId id = add_body(test, body, top, 0.2, 5);
      // A round top moves on under the particle before it first sticks.
      const bool flat = body != Body::sphere && body != Body::capsule;
      const double within = flat ? tolerance(GetParam(), 1) : 2e-5;
      for (int n = 1; n <= 60; ++n) {
        const Vec by = (n * dt) * velocity;
        test.check(test.world().move_collider(id, shift(by)));
        test.step(dt);
        ASSERT_LE(length(test.position(cloth, 0) - (top + by)), within) << n << " steps";
      }
    }
}

TEST_P(ColliderMotion, ATurningTableCarriesAStickingParticleAlongItsArc) {
  const Vec start = top + Vec{0.12, 0, 0.1};
  for (const Body body : {Body::plane, Body::cylinder, Body::box, Body::mesh})
    for (const uint32_t substeps : {1u, 8u}) {
      SCOPED_TRACE(testing::Message() << name(body) << " " << substeps);
      TestWorld test(heavy(GetParam(), substeps));
      const weft::ClothId cloth = add_particles(test, {start});
      const weft::ColliderId id = add_body(test, body, top, 0.2, 2);
      for (int n = 1; n <= 200; ++n) {
        const double degrees = 0.1 * n;
        // About the vertical through `top`: x' = R x + (top - R top).
        const Vec to = top - turned(top, {0, 1, 0}, degrees);
        test.check(test.world().move_collider(id, {{0, 2, 0}, degrees, to_weft(to)}));
        test.step(dt);
        const Vec expected = top + turned(start - top, {0, 1, 0}, degrees);
        ASSERT_LE(length(test.position(cloth, 0) - expected), 2e-5) << n << " steps";
      }
    }
}

TEST_P(ColliderMotion, AStickingParticleDoesNotCreepOnATurningTable) {
  const Vec start = top + Vec{0.12, 0, 0.1};
  for (const Body body : {Body::cylinder, Body::box, Body::mesh}) {
    SCOPED_TRACE(name(body));
    TestWorld test(heavy(GetParam(), 1));
    const weft::ClothId cloth = add_particles(test, {start});
    const weft::ColliderId id = add_body(test, body, top, 0.2, 100);
    const auto on_table = [&](double degrees) {
      return turned(test.position(cloth, 0) - top, {0, 1, 0}, -degrees);
    };
    Vec stuck;
    for (int n = 1; n <= 360; ++n) {
      const Vec to = top - turned(top, {0, 1, 0}, n);
      test.check(test.world().move_collider(id, {{0, 1, 0}, double(n), to_weft(to)}));
      test.step(dt);
      if (n == 2) stuck = on_table(n);
    }
    EXPECT_LE(length(on_table(360) - stuck), GetParam() == weft::Precision::float64 ? 1e-9 : 2e-5);
  }
}

TEST_P(ColliderMotion, ASheetOfTrianglesTiltsTravelsAndKeepsItsParticle) {
  const Vec start{0.05, 0.01, 0.1};
  for (const uint32_t substeps : {8u, 20u}) {
    TestWorld test(heavy(GetParam(), substeps));
    const weft::ClothId cloth = add_particles(test, {start});
    weft::MeshColliderDesc desc;
    desc.friction = 2;
    const weft::ColliderId id = add_collider(test, square(0.5), 0.01, false, desc);
    for (int n = 1; n <= 200; ++n) {
      const double degrees = 0.1 * n;
      const Vec to = (n * dt) * Vec{0.02, 0.05, 0.01};
      test.check(test.world().move_collider(id, {to_weft(beside), degrees, to_weft(to)}));
      test.step(dt);
      const Vec expected = turned(start, beside, degrees) + to;
      ASSERT_LE(length(test.position(cloth, 0) - expected), 2e-5) << n << " steps";
    }
  }
}

TEST_P(ColliderMotion, AColliderRestsWhereItWasMoved) {
  TestWorld test(plain_world(GetParam()));
  const Vec ahead_of_it = top + Vec{0, 0.5, 0};
  const weft::ClothId cloth = add_particles(test, {ahead_of_it});
  const weft::ColliderId id = add_body(test, Body::box, top, 0.2, 0, {0, 1, 0});
  test.check(test.world().move_collider(id, shift({0, 0.4, 0})));
  test.step(dt, 100);
  EXPECT_TRUE(same_bits(test.position(cloth, 0), ahead_of_it));
}

/// Speed over the next step.
double speed_after(TestWorld& test, weft::ClothId cloth) {
  const Vec before = test.position(cloth, 0);
  test.step(dt);
  return length(test.position(cloth, 0) - before) / dt;
}

TEST_P(ColliderMotion, ATeleportOntoAParticleGivesItNoVelocity) {
  const double radius = 0.1;
  for (const Vec off : {Vec{0, 0, 0}, 0.05 * across, 0.0999 * ahead})
    for (const Vec velocity : {Vec{0, 0, 0}, 0.5 * beside, 2 * across}) {
      SCOPED_TRACE(testing::Message() << "at " << length(off) << ", " << length(velocity));
      TestWorld test(plain_world(GetParam(), weft::Start::lagged));
      const weft::ClothId cloth = add_particles(test, {top}, velocity);
      weft::SphereDesc sphere;
      sphere.radius = radius;
      sphere.center = to_weft(top - off + 10 * radius * ahead);
      const weft::ColliderId id = test.take(test.world().create_sphere(sphere));
      test.check(test.world().move_collider(id, shift(-10 * radius * ahead), weft::Move::teleport));
      test.step(dt);
      EXPECT_GE(length(test.position(cloth, 0) - (top - off)), radius * (1 - 1e-5));
      EXPECT_LE(speed_after(test, cloth), length(velocity) + 1e-4);
    }
}

TEST_P(ColliderMotion, ATeleportAwayLeavesEveryBit) {
  for (const Body body : every_body) {
    SCOPED_TRACE(name(body));
    TestWorld test(plain_world(GetParam())), alone(plain_world(GetParam()));
    const std::vector<Vec> at{top, top + Vec{0.1, 0, 0.05}, top - Vec{0, 5, 0}};
    add_particles(test, at, {0, 0.25, 0});
    add_particles(alone, at, {0, 0.25, 0});
    const weft::ColliderId id = add_body(test, body, top - Vec{0, 0.3, 0}, 0.2);
    const uint64_t before = test.hash();
    test.check(test.world().move_collider(id, shift({3, -70, 1}), weft::Move::teleport));
    EXPECT_EQ(test.hash(), before);
    for (int n = 0; n < 20; ++n) {
      test.step(dt);
      alone.step(dt);
      ASSERT_EQ(test.hash(), alone.hash());
    }
  }
}

TEST(BadMove, EveryArgumentIsChecked) {
  TestWorld test;
  add_particles(test, {{0, 5, 0}});
  const weft::ColliderId id = add_body(test, Body::box, {0, 0, 0}, 1);
  const auto refuse = [&](const weft::Pose& pose, const char* word) {
    for (const weft::Move how : {weft::Move::simulate, weft::Move::teleport})
      expect_refused_unchanged(test, {word},
                               [&] { return test.world().move_collider(id, pose, how); });
  };
  for (const double bad : {infinity, -infinity, not_a_number}) {
    refuse(shift({0, bad, 0}), "pose.translate");
    refuse({{1, 0, 0}, bad, {}}, "pose");
    refuse({{bad, 0, 0}, 10, {}}, "pose");
  }
  refuse({{0, 0, 0}, 10, {}}, "pose");
  expect_refused_unchanged(test, {"7"},
                           [&] { return test.world().move_collider(id, {}, weft::Move(7)); });
  test.check(test.world().move_collider(id, {{0, 0, 0}, 0, {}}));
  test.check(test.world().destroy_collider(id));
  for (const weft::ColliderId stale : {id, weft::ColliderId{}})
    expect_refused_unchanged(
        test, {}, [&] { return test.world().move_collider(stale, {}); },
        weft::Status::invalid_handle);
}

INSTANTIATE_TEST_SUITE_P(Precision, ColliderMotion, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::collider_motion
