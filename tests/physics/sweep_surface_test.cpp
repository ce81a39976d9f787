// Particles on a surface and the sweep: what rests or slides is left alone, what is thin holds, and
// what flies into the end of a long body stops there (HC45).
#include "reference/effects.h"
#include "reference/random.h"

namespace weft_tests::sweep_surface {
namespace {

using SweepSurface = BothPrecisions;

constexpr double dt = 1.0 / 60;

TEST_P(SweepSurface, AParticleAtRestOnASurfaceIsNotDisturbed) {
  for (const Body body : every_body)
    for (const double size : {0.001, 0.1}) {
      SCOPED_TRACE(testing::Message() << name(body) << " " << size);
      TestWorld test(plain_world(GetParam()));
      const Vec start{0.25, 0.5, -0.125};
      const weft::ClothId cloth = add_particles(test, {start});
      add_body(test, body, start, size);
      test.step(dt, 50);
      expect_near(test.position(cloth, 0), start, 1e-7);
      // g dt^2 is more than the smaller ones are wide.
      test.check(test.world().set_gravity({0, -9.81, 0}));
      test.step(dt, 50);
      expect_near(test.position(cloth, 0), start, 2e-6);
    }
}

/// How many of 300 particles, each `height` or more above a plate, are below it after 3 s.
int fallen_through(weft::WorldDesc desc, double half, double height, double more) {
  desc.gravity = {0, -9.81, 0};
  TestWorld test(desc);
  reference::SplitMix random(5);
  std::vector<Vec> start;
  for (int i = 0; i < 300; ++i) {
    const Vec at = random.noise(1);
    start.push_back({at.x, 0.3 + height + more * random.uniform(), at.z});
  }
  const weft::ClothId cloth = add_particles(test, start);
  weft::BoxDesc plate;
  plate.center = {0, 0.3 - half, 0};
  plate.half = {2, half, 2};
  test.take(test.world().create_box(plate));
  test.step(dt, 180);
  int fallen = 0;
  for (const Vec x : test.positions(cloth)) fallen += x.y < 0.3 - 1e-3;
  return fallen;
}

TEST_P(SweepSurface, ThinPlatesHoldWhatRestsOnThemAndWhatIsDropped) {
  for (const weft::Form form : {weft::Form::summed, weft::Form::position})
    for (const double half : {0.0005, 0.001, 0.0026, 0.005, 0.02, 0.05}) {
      SCOPED_TRACE(testing::Message() << "half a thickness of " << half << ", " << int(form));
      weft::WorldDesc desc = plain_world(GetParam());
      desc.form = form;
      EXPECT_EQ(fallen_through(desc, half, 0, 0), 0) << "resting";
      EXPECT_EQ(fallen_through(desc, half, 0.5, 4), 0) << "dropped";
    }
}

TEST_P(SweepSurface, AParticleThatSlidesFastAlongAFlatTopIsNotStopped) {
  for (const Body body : {Body::plane, Body::box, Body::cylinder})
    for (const double gravity : {0.0, 9.81, 300.0}) {
      SCOPED_TRACE(testing::Message() << name(body) << " " << gravity);
      weft::WorldDesc desc = plain_world(GetParam(), weft::Start::lagged);
      desc.gravity = {0, -gravity, 0};
      TestWorld test(desc);
      // With size 1 the sweep begins at 0.25 m a step; it goes 0.375 m, the gravity sinks 0.083 m.
      const weft::ClothId cloth = add_particles(test, {{-0.9, 1, 0}}, {0.375 / dt, 0, 0});
      add_body(test, body, {0, 1, 0}, 1);
      for (int n = 1; n <= 4; ++n) {
        test.step(dt);
        expect_near(test.position(cloth, 0), {-0.9 + 0.375 * n, 1, 0}, 1e-5);
      }
    }
}

TEST_P(SweepSurface, AParticleThatSlidesFastOverASphereIsNotStopped) {
  for (const double radius : {0.02, 0.1, 1.0, 10.0})
    for (const double share : {0.1, 0.2, 0.3, 0.4})        // way per step by radius
      for (const double sink : {0.0, 0.02, 0.04, 0.06}) {  // g dt^2 by radius
        SCOPED_TRACE(testing::Message()
                     << "R " << radius << ", way " << share << " R, sinks " << sink << " R a step");
        weft::WorldDesc desc = plain_world(GetParam(), weft::Start::lagged);
        desc.gravity = {0, -sink * radius / (dt * dt), 0};
        TestWorld test(desc);
        const Vec start{0, radius, 0};
        const weft::ClothId cloth = add_particles(test, {start}, {share * radius / dt, 0, 0});
        weft::SphereDesc sphere;
        sphere.radius = radius;
        test.take(test.world().create_sphere(sphere));
        test.step(dt);
        // Free flight, or less what going around the sphere takes off: 1 - cos of a third.
        const Vec x = test.position(cloth, 0);
        EXPECT_GE(x.x, 0.9 * share * radius);
        EXPECT_GE(length(x), radius * (1 - 1e-5));
      }
}

/// Flies into the end of a long body at x = 0, which is round by `roundness`, and would end inside
/// it, near to its side.
template <class Create>
void expect_stop_at_end(weft::Precision precision, double roundness, Create create) {
  for (const double off_axis : {0.0, 0.005}) {
    const double end = roundness - std::sqrt(std::abs(roundness * roundness - off_axis * off_axis));
    TestWorld test(plain_world(precision, weft::Start::lagged));
    const Vec start{-0.1, off_axis, 0};
    const weft::ClothId cloth = add_particles(test, {start}, {30, 0, 0});
    create(test);
    test.step(dt);
    const Vec x = test.position(cloth, 0);
    EXPECT_NEAR(x.x, roundness > 0 ? end : 0, 1e-5)
        << "went through the end to " << x.x << ", " << x.y << ", " << x.z;
    EXPECT_NEAR(x.y, off_axis, 1e-5);
  }
}

TEST_P(SweepSurface, AFlightIntoTheEndOfALongBodyStopsThere) {
  expect_stop_at_end(GetParam(), 0, [](TestWorld& test) {
    weft::CylinderDesc cylinder;
    cylinder.a = {0, 0, 0};
    cylinder.b = {2, 0, 0};
    cylinder.radius = 0.02;
    test.take(test.world().create_cylinder(cylinder));
  });
  expect_stop_at_end(GetParam(), 0, [](TestWorld& test) {
    weft::BoxDesc box;
    box.center = {1, 0, 0};
    box.half = {1, 0.02, 0.03};
    test.take(test.world().create_box(box));
  });
  expect_stop_at_end(GetParam(), 0.02, [](TestWorld& test) {
    weft::CapsuleDesc capsule;
    capsule.a = {0.02, 0, 0};
    capsule.b = {2, 0, 0};
    capsule.radius = 0.02;
    test.take(test.world().create_capsule(capsule));
  });
  expect_stop_at_end(GetParam(), 0, [](TestWorld& test) {
    weft::MeshColliderDesc desc;
    desc.pose.translate = {1, 0, 0};
    add_collider(test, reference::box({0.99, 0.01, 0.02}), 0.01, true, desc);
  });
}

INSTANTIATE_TEST_SUITE_P(Precision, SweepSurface, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::sweep_surface
