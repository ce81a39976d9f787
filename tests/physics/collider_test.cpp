// Frictionless spheres and planes: the position after contact is known exactly (HC43, HC47, HC49,
// HC53, HC55).
#include "reference/networks.h"
#include "reference/sheets.h"

#include <numbers>

namespace weft_tests {
namespace {

using Collider = BothPrecisions;

weft::WorldDesc falling(weft::Precision precision, weft::Start start = weft::Start::taylor) {
  weft::WorldDesc desc = plain_world(precision, start);
  desc.gravity = {0, -9.81, 0};
  return desc;
}

TEST_P(Collider, ParticleAtTheCentreLeavesAlongY) {
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = add_particles(test, {{0.25, 0.5, -1}});
  weft::SphereDesc sphere;
  sphere.center = {0.25, 0.5, -1};
  sphere.radius = 0.75;
  test.take(test.world().create_sphere(sphere));
  test.step(0.01);
  const Vec x = test.position(cloth, 0);
  EXPECT_NEAR(length(x - Vec{0.25, 0.5, -1}), 0.75, 0.75e-6);
  EXPECT_EQ(x.x, 0.25);
  EXPECT_EQ(x.z, -1);
  EXPECT_GT(x.y, 0.5);
}

TEST_P(Collider, ParticleInsideASphereGoesToItsSurfaceAlongTheNormal) {
  TestWorld test(plain_world(GetParam()));
  const Vec c{1, 2, 3}, out{0.6, 0, 0.8};
  const weft::ClothId cloth = add_particles(test, {c + 0.3 * out, c + 1.5 * out});
  weft::SphereDesc sphere;
  sphere.center = to_weft(c);
  sphere.radius = 1.25;
  const weft::ColliderId id = test.take(test.world().create_sphere(sphere));
  test.step(0.01);
  expect_near(test.position(cloth, 0), c + 1.25 * out, tolerance(GetParam(), 4));
  expect_near(test.position(cloth, 1), c + 1.5 * out, tolerance(GetParam(), 4));
  test.check(test.world().destroy_collider(id));
  EXPECT_NE(test.world().destroy_collider(id), weft::Status::ok);
}

TEST_P(Collider, DropOfOneMetreEndsOnThePlaneAtStep108) {
  const double dt = 1.0 / 240;
  TestWorld test(falling(GetParam(), weft::Start::lagged));
  const weft::ClothId cloth = add_particles(test, {{0.25, 1, 0}});
  test.take(test.world().create_plane({}));
  for (int n = 1; n < 108; ++n) {
    test.step(dt);
    const double y = 1 - 9.81 * dt * dt * n * (n + 1) / 2;
    ASSERT_GT(y, 0);
    ASSERT_NEAR(test.position(cloth, 0).y, y, tolerance(GetParam(), 1)) << n;
  }
  for (int n = 108; n < 200; ++n) {
    test.step(dt);
    ASSERT_EQ(test.position(cloth, 0).y, 0) << n;
    ASSERT_EQ(test.position(cloth, 0).x, 0.25) << n;
  }
  EXPECT_NEAR(test.velocities(cloth)[0].y, 0, tolerance(GetParam(), 4.43)) << "at rest";
}

TEST_P(Collider, PinInsideAColliderStays) {
  TestWorld test(falling(GetParam()));
  AnchoredMass mass;
  mass.stiffness = 0;
  mass.start = {5, 0, 0};
  const weft::ClothId cloth = mass.add_to(test);
  weft::SphereDesc sphere;
  sphere.center = {0.125, 0, 0};
  sphere.radius = 1;
  test.take(test.world().create_sphere(sphere));
  weft::PlaneDesc plane;
  plane.normal = {-1, 0, 0};
  plane.offset = 2;  // x > -2 is inside: all of the particles
  test.take(test.world().create_plane(plane));
  test.step(0.01);
  EXPECT_TRUE(same_bits(test.position(cloth, 0), Vec{0, 0, 0}));
  EXPECT_NEAR(test.position(cloth, 1).x, -2, tolerance(GetParam(), 5));
  test.step(0.01, 50);
  EXPECT_TRUE(same_bits(test.position(cloth, 0), Vec{0, 0, 0}));
}

TEST_P(Collider, PlaneNormalIsNormalised) {
  weft::PlaneDesc unit, scaled;
  unit.normal = {0, 0, 1};
  scaled.normal = {0, 0, 2};
  unit.offset = scaled.offset = 0.5;
  for (const weft::PlaneDesc& plane : {unit, scaled}) {
    TestWorld test(plain_world(GetParam()));
    const weft::ClothId cloth = add_particles(test, {{0, 0, 0}, {0, 0, 0.75}});
    test.take(test.world().create_plane(plane));
    test.step(0.01);
    EXPECT_EQ(test.position(cloth, 0).z, 0.5);
    EXPECT_EQ(test.position(cloth, 1).z, 0.75);
  }
}

TEST_P(Collider, RisingPlaneCarriesAParticle) {
  const double speed = 0.5, dt = 0.01;
  for (uint32_t substeps : {1u, 4u}) {
    weft::WorldDesc desc = falling(GetParam());
    desc.substeps = substeps;
    TestWorld test(desc);
    const weft::ClothId cloth = add_particles(test, {{0, 0, 0}});
    weft::PlaneDesc plane;
    plane.velocity = {0, speed, 0};
    test.take(test.world().create_plane(plane));
    for (int n = 1; n <= 200; ++n) {
      test.step(dt);
      ASSERT_NEAR(test.position(cloth, 0).y, speed * n * dt, tolerance(GetParam(), 1)) << n;
    }
  }
}

TEST_P(Collider, RisingSphereCarriesAParticleOnItsPole) {
  const double speed = 0.5, dt = 0.01;
  TestWorld test(falling(GetParam()));
  const weft::ClothId cloth = add_particles(test, {{0, 1, 0}});
  weft::SphereDesc sphere;
  sphere.velocity = {0, speed, 0};
  test.take(test.world().create_sphere(sphere));
  for (int n = 1; n <= 200; ++n) {
    test.step(dt);
    ASSERT_NEAR(test.position(cloth, 0).y, 1 + speed * n * dt, tolerance(GetParam(), 2)) << n;
    ASSERT_EQ(test.position(cloth, 0).x, 0) << n;
  }
}

TEST(FrictionlessSphere, ParticleSlidesOffAtTwoThirdsOfItsHeight) {
  const double start = 0.05, dt = 0.001;
  TestWorld test(falling(weft::Precision::float64));
  const weft::ClothId cloth = add_particles(test, {{std::sin(start), std::cos(start), 0}});
  test.take(test.world().create_sphere({}));
  for (int n = 0; n < 3000; ++n) {
    const Vec before = test.position(cloth, 0);
    test.step(dt);
    const Vec x = test.position(cloth, 0);
    ASSERT_GE(length(x), 1 - 1e-12);
    if (n > 10 && length(x) > 1 + 1e-12) {
      const double angle = std::acos(before.y) * 180 / std::numbers::pi;
      EXPECT_NEAR(angle, 48.2537, 0.2);
      EXPECT_NEAR(length(x - before) / dt, 2.55574, 0.0255574);
      return;
    }
  }
  FAIL() << "it never left";
}

TEST_P(Collider, SheetStaysOutOfSphereAndPlane) {
  weft::WorldDesc desc = falling(GetParam());
  desc.substeps = 0;
  TestWorld test(desc);
  Sheet sheet;
  sheet.rows = sheet.columns = 20;
  sheet.stiffness = 50;
  weft::ClothDesc cloth_desc;
  cloth_desc.drag = 0.01;
  cloth_desc.pose.axis = {1, 0, 0};
  cloth_desc.pose.degrees = 90;
  cloth_desc.pose.translate = {-0.5, 0.75, -0.5};
  const weft::ClothId cloth = test.add(sheet.grid(), cloth_desc);
  weft::SphereDesc sphere;
  sphere.radius = 0.5;
  test.take(test.world().create_sphere(sphere));
  weft::PlaneDesc plane;
  plane.offset = -0.25;
  test.take(test.world().create_plane(plane));
  int touching = 0;
  for (int frame = 0; frame < 120; ++frame) {
    test.step(1.0 / 60);
    touching = 0;
    for (Vec x : test.positions(cloth)) {
      // The plane is the later collider; a vertex between both may be left in the sphere.
      ASSERT_GE(x.y, -0.25 - 1e-6);
      if (x.y > -0.2) {
        ASSERT_GE(length(x), 0.5 - 1e-6);
      }
      touching += length(x) < 0.5 + 1e-5;
    }
  }
  EXPECT_GT(touching, 0);
}

INSTANTIATE_TEST_SUITE_P(Precision, Collider, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests
