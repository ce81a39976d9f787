// Fast colliders sweep up particles at rest (HC45).
#include "reference/effects.h"

namespace weft_tests::sweep_motion {
namespace {

using SweepMotion = BothPrecisions;

constexpr double dt = 1.0 / 60;
constexpr Vec centre{0.3, -0.2, 0.1};

enum class Drive { velocity, pose };

/// A ball of `radius` that flies by `way` in one step; returns where the particle `at` ends, and
/// its velocity from there on.
std::pair<Vec, Vec> swept_up(weft::Precision precision, Drive drive, double radius, Vec way,
                             Vec at) {
  TestWorld test(plain_world(precision, weft::Start::lagged));
  const weft::ClothId cloth = add_particles(test, {at});
  weft::SphereDesc sphere;
  sphere.center = to_weft(centre);
  sphere.radius = radius;
  if (drive == Drive::velocity) sphere.velocity = to_weft((1 / dt) * way);
  const weft::ColliderId id = test.take(test.world().create_sphere(sphere));
  weft::Pose pose;
  pose.translate = to_weft(way);
  if (drive == Drive::pose) test.check(test.world().move_collider(id, pose));
  test.step(dt);
  const Vec x = test.position(cloth, 0);
  test.check(test.world().destroy_collider(id));
  test.step(dt);
  return {x, (1 / dt) * (test.position(cloth, 0) - x)};
}

TEST_P(SweepMotion, AFastSphereTakesAlongWhatItMeets) {
  const double radius = 0.02;
  for (const Drive drive : {Drive::velocity, Drive::pose})
    for (const double speed : {30.0, 300.0})
      for (const double b : {0.0, 0.5, 0.9}) {
        SCOPED_TRACE(testing::Message() << speed << " m/s, b/R " << b << " " << int(drive));
        const Vec way = speed * dt * ahead;
        const double chord = radius * std::sqrt(1 - b * b);
        const Vec from_centre = b * radius * across + chord * ahead;
        const Vec at = centre + from_centre + 0.6 * way;
        const auto [x, v] = swept_up(GetParam(), drive, radius, way, at);
        const double within = 1e-5 * speed * dt;
        expect_near(x, centre + way + from_centre, within);
        // It leaves with the sphere's velocity along the normal: nothing was sticking.
        const Vec normal = (1 / radius) * from_centre;
        expect_near(v, speed * dot(ahead, normal) * normal, 1e-4 * speed);
      }
}

TEST_P(SweepMotion, AnAlmostMissedParticleStaysWhereItIs) {
  const double radius = 0.02;
  for (const Drive drive : {Drive::velocity, Drive::pose}) {
    const Vec at = centre + 1.001 * radius * across + 0.3 * ahead;
    const auto [x, v] = swept_up(GetParam(), drive, radius, 0.5 * ahead, at);
    expect_near(x, at, 1e-7);
    expect_near(v, {}, 1e-5);
  }
}

TEST_P(SweepMotion, ARodThatTurnsByARightAngleHitsWithItsFace) {
  weft::BoxDesc rod;
  rod.half = {1, 0.05, 0.05};
  for (const uint32_t substeps : {1u, 3u, 24u, 32u})
    for (const double radius : {0.2, 0.6, 0.7}) {  // frictionless, it slides out to r cosh(angle)
      SCOPED_TRACE(testing::Message() << substeps << " substeps, at " << radius << " m");
      weft::WorldDesc desc = plain_world(GetParam());
      desc.substeps = substeps;
      TestWorld test(desc);
      const double s = radius * std::sqrt(0.5);
      const weft::ClothId cloth = add_particles(test, {{s, s, 0.01}});
      const weft::ColliderId id = test.take(test.world().create_box(rod));
      test.check(test.world().move_collider(id, {{0, 0, 1}, 90, {}}));
      test.step(dt);
      const Vec x = test.position(cloth, 0);
      // The face that led is now at x = -0.05; once hit, a particle may fly ahead of it.
      EXPECT_LE(x.x, -0.05 + 1e-5);
      EXPECT_GE(x.x, substeps == 1 ? -0.05 - 1e-5 : -radius);
      EXPECT_GT(x.y, 0);
      EXPECT_NEAR(x.z, 0.01, 1e-6);
    }
}

/// Where a body that rises by half a metre in one step takes a resting particle 0.3 m above it.
TEST_P(SweepMotion, AFastBodyOfAnyShapeTakesAlongWhatIsAboveIt) {
  const Vec top{0.25, 0.5, -0.125}, way{0, 0.5, 0};
  for (const Drive drive : {Drive::velocity, Drive::pose})
    for (const Body body : every_body) {
      SCOPED_TRACE(testing::Message() << name(body) << " " << int(drive));
      TestWorld test(plain_world(GetParam(), weft::Start::lagged));
      const weft::ClothId cloth = add_particles(test, {top + Vec{0, 0.3, 0}});
      const bool drifts = drive == Drive::velocity;
      const Vec velocity = drifts ? (1 / dt) * way : Vec{};
      const weft::ColliderId id = add_body(test, body, top, 0.02, 0, velocity);
      if (!drifts) test.check(test.world().move_collider(id, {{1, 0, 0}, 0, to_weft(way)}));
      test.step(dt);
      expect_near(test.position(cloth, 0), top + way, 1e-5 * 0.5);
      test.check(test.world().destroy_collider(id));
      test.step(dt);
      const double after = test.position(cloth, 0).y - (top + way).y;
      EXPECT_GE(after, 0.2 * (1 - 1e-4)) << "it was pushed by 0.2 m in that step";
      EXPECT_LE(after, 0.5 * (1 + 1e-4)) << "the body came with 0.5 m a step";
    }
}

INSTANTIATE_TEST_SUITE_P(Precision, SweepMotion, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::sweep_motion
