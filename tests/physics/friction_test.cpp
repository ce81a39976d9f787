// Coulomb friction against its exact discrete solutions (HC48, HC55), and what sticks to what
// moves.
#include "reference/networks.h"

#include <cmath>
#include <numbers>

namespace weft_tests::friction {
namespace {

using Friction = BothPrecisions;

constexpr double g = 9.81;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// How far a particle has gone down an incline after a second of 1/1000 s.
double slide(weft::Precision precision, double degrees, double of_tangent) {
  const double angle = radians(degrees);
  weft::WorldDesc desc = plain_world(precision, weft::Start::lagged);
  desc.gravity = {0, -g, 0};
  TestWorld test(desc);
  const weft::ClothId cloth = add_particles(test, {{0, 0, 0}});
  weft::PlaneDesc plane;
  plane.normal = {std::sin(angle), std::cos(angle), 0};
  plane.friction = of_tangent * std::tan(angle);
  test.take(test.world().create_plane(plane));
  for (int n = 0; n < 1000; ++n) test.step(0.001);
  const Vec x = test.position(cloth, 0);
  EXPECT_NEAR(x.x * std::sin(angle) + x.y * std::cos(angle), 0, 1e-7) << "left the plane";
  return x.x * std::cos(angle) - x.y * std::sin(angle);
}

TEST_P(Friction, AnInclineBelowTheConeSlidesByTheDiscreteLaw) {
  const std::pair<double, double> cases[] = {
      {20, 0.001679286}, {30, 0.002454952}, {45, 0.003471827}};
  for (const auto& [degrees, expected] : cases) {
    const double a = radians(degrees);
    const double mu = 0.999 * std::tan(a);
    const double exact = (g * std::sin(a) - mu * g * std::cos(a)) * 1e-6 * 1000 * 1001 / 2;
    EXPECT_NEAR(exact, expected, 5e-10);
    // float32: the net force is a thousandth of its two parts, each rounded to 6e-8 of itself.
    const double allowed = GetParam() == weft::Precision::float64 ? 1e-10 : 1e-3 * expected;
    EXPECT_NEAR(slide(GetParam(), degrees, 0.999), expected, allowed + 5e-10) << degrees;
  }
}

TEST_P(Friction, AnInclineWithinTheConeDoesNotCreep) {
  for (const double degrees : {20.0, 30.0, 45.0}) {
    EXPECT_LT(std::abs(slide(GetParam(), degrees, 1.001)), 1e-6) << degrees;
  }
}

TEST_P(Friction, WithoutFrictionTheWholeSlopeAccelerates) {
  const double a = radians(30);
  const double expected = g * std::sin(a) * 1e-6 * 1000 * 1001 / 2;
  EXPECT_NEAR(slide(GetParam(), 30, 0), expected, tolerance(GetParam(), expected));
}

TEST_P(Friction, ABeltCarriesAParticleUpToItsSpeedAndNoFurther) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -g, 0};
  TestWorld test(desc);
  const weft::ClothId cloth = add_particles(test, {{0, 0, 0}});
  weft::PlaneDesc belt;
  belt.velocity = {0.5, 0, 0};
  belt.friction = 0.4;
  test.take(test.world().create_plane(belt));
  double before = 0;
  for (int n = 1; n <= 500; ++n) {
    before = test.position(cloth, 0).x;
    test.step(0.002);
  }
  EXPECT_NEAR((test.position(cloth, 0).x - before) / 0.002, 0.5,
              GetParam() == weft::Precision::float64 ? 1e-9 : 1e-4);
  // At 0.4 g it takes 0.127 s and 0.032 m to catch up with the belt.
  EXPECT_NEAR(test.position(cloth, 0).x, 0.5 - 0.5 * 0.5 * 0.5 / (0.4 * g), 2e-3);
}

TEST_P(Friction, AParticleRestsOnAPlaneThatRises) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -g, 0};
  TestWorld test(desc);
  const weft::ClothId cloth = add_particles(test, {{0.25, 0, 0}});
  weft::PlaneDesc lift;
  lift.velocity = {0, 0.3, 0};
  lift.friction = 0.7;
  test.take(test.world().create_plane(lift));
  for (int n = 1; n <= 300; ++n) {
    test.step(0.005);
    ASSERT_NEAR(test.position(cloth, 0).y, 0.3 * n * 0.005, tolerance(GetParam(), 1)) << n;
  }
  EXPECT_EQ(test.position(cloth, 0).x, 0.25);
}

TEST_P(Friction, DeepOverlapIsResolvedWithoutEjection) {
  TestWorld test(plain_world(GetParam()));
  const weft::ClothId cloth = add_particles(test, {{0, -1, 0}});
  test.take(test.world().create_plane({}));
  for (int n = 0; n < 10; ++n) test.step(1.0 / 60);
  EXPECT_NEAR(test.position(cloth, 0).y, 0, tolerance(GetParam(), 1));
}

TEST_P(Friction, AWedgeOfTwoPlanesStaysBounded) {
  weft::WorldDesc desc = plain_world(GetParam());
  desc.gravity = {0, -g, 0};
  TestWorld test(desc);
  const weft::ClothId cloth = add_particles(test, {{0, 0.2, 0}});
  for (const double side : {-1.0, 1.0}) {  // a wedge of 20 degrees with its edge at the origin
    weft::PlaneDesc wall;
    wall.normal = {side * std::cos(radians(10)), std::sin(radians(10)), 0};
    wall.friction = 0.3;
    test.take(test.world().create_plane(wall));
  }
  double highest = 0, widest = 0;
  for (int n = 0; n < 2000; ++n) {
    test.step(0.002);
    const Vec x = test.position(cloth, 0);
    ASSERT_TRUE(std::isfinite(x.y));
    highest = std::max(highest, x.y);
    widest = std::max(widest, std::abs(x.x));
  }
  EXPECT_LE(highest, 0.2 + 1e-6);
  EXPECT_LE(widest, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Precision, Friction, both_precisions(), precision_name);

}  // namespace
/// 30 degrees down, on the side of a capsule, the face of a box and a sheet of triangles.
TEST(FrictionInFloat, NothingCreepsOnAnyShapeInAnyForm) {
  const double a = std::numbers::pi / 6, mu = 1.1 * std::tan(a);
  const Vec normal{-std::sin(a), std::cos(a), 0}, down{-std::cos(a), -std::sin(a), 0};
  for (const weft::Form form : {weft::Form::summed, weft::Form::position}) {
    for (int shape = 0; shape < 3; ++shape) {
      SCOPED_TRACE(testing::Message() << int(form) << " " << shape);
      weft::WorldDesc desc;
      desc.form = form;
      desc.substeps = 1;
      desc.start = weft::Start::lagged;
      TestWorld test(desc);
      NetworkParts parts;
      parts.positions = {{0, 0, 0}};
      parts.masses = {1};
      const weft::ClothId id = add_network(test, parts, {});
      if (shape == 0) {
        weft::CapsuleDesc capsule;
        capsule.a = to_weft(-1.0 * normal + 2 * down);
        capsule.b = to_weft(-1.0 * normal - 2 * down);
        capsule.friction = mu;
        test.take(test.world().create_capsule(capsule));
      } else if (shape == 1) {
        weft::BoxDesc box;
        box.center = to_weft(-1.0 * normal);
        box.axis = {0, 0, 1};
        box.degrees = 30;
        box.friction = mu;
        test.take(test.world().create_box(box));
      } else {
        const double t = 0.01;
        const Vec at = -t * normal;
        const std::vector<weft::double3> x{to_weft(at + down + Vec{0, 0, 1}),
                                           to_weft(at + down - Vec{0, 0, 1}),
                                           to_weft(at - 2 * down)};
        const std::vector<uint32_t> corners{0, 1, 2};
        weft::ColliderMeshDesc mesh;
        mesh.positions = weft::View<weft::double3>(x);
        mesh.indices = corners;
        mesh.thickness = t;
        weft::MeshColliderDesc collider;
        collider.mesh = test.cook(mesh);
        collider.friction = mu;
        test.take(test.world().create_mesh(collider));
      }
      test.step(1e-3, 10);  // the first contact
      const Vec before = test.position(id, 0);
      test.step(1e-3, 1000);
      const Vec after = test.position(id, 0);
      EXPECT_LT(length(after - before), 1e-6);
      EXPECT_LT(length(before), 1e-4);
    }
  }
}

}  // namespace weft_tests::friction
