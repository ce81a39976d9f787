// Fast particles stop where they enter a collider: the time of the hit in closed form (HC45).
#include "reference/effects.h"

namespace weft_tests::sweep {
namespace {

using Sweep = BothPrecisions;

constexpr double dt = 1.0 / 60;
constexpr double speeds[] = {30, 300};
constexpr Vec centre{0.3, -0.2, 0.1};

/// Where a free particle is after one step.
template <class Create>
Vec after_flight(weft::Precision precision, Vec start, Vec velocity, Create create) {
  TestWorld test(plain_world(precision, weft::Start::lagged));
  const weft::ClothId cloth = add_particles(test, {start}, velocity);
  create(test);
  test.step(dt);
  return test.position(cloth, 0);
}

/// Flies along `direction` and must be stopped at `hit`, which is `distance` away.
template <class Create>
void expect_stop(weft::Precision precision, Vec hit, Vec direction, double distance, double speed,
                 Create create) {
  const Vec x = after_flight(precision, hit - distance * direction, speed * direction, create);
  const double along = dot(x - hit, direction);
  EXPECT_LE(along, 1e-5 * speed * dt) << "beyond the surface";
  EXPECT_LE(length(x - hit), 1e-5 * speed * dt)
      << "hit after " << (distance + along) / speed << " s, not " << distance / speed << ", and "
      << length(x - hit - along * direction) << " m beside";
}

void sphere_at_centre(TestWorld& test, double radius) {
  weft::SphereDesc sphere;
  sphere.center = to_weft(centre);
  sphere.radius = radius;
  test.take(test.world().create_sphere(sphere));
}

TEST_P(Sweep, ASphereIsHitWhereTheChordBegins) {
  for (const double speed : speeds)
    for (const double radius : {0.01, 0.05})
      for (const double b : {0.0, 0.5, 0.9})
        for (const double share : {0.3, 0.7}) {
          SCOPED_TRACE(testing::Message() << speed << " m/s, R " << radius << ", b/R " << b);
          const double chord = radius * std::sqrt(1 - b * b), away = share * speed * dt - chord;
          const Vec hit = centre + b * radius * across - chord * ahead;
          expect_stop(GetParam(), hit, ahead, away, speed,
                      [&](TestWorld& test) { sphere_at_centre(test, radius); });
        }
}

TEST_P(Sweep, ACapsuleIsHitOnItsSideAndOnItsEnds) {
  const double radius = 0.02, half = 0.06;
  const auto create = [&](TestWorld& test) {
    weft::CapsuleDesc capsule;
    capsule.a = to_weft(centre - half * beside);
    capsule.b = to_weft(centre + half * beside);
    capsule.radius = radius;
    test.take(test.world().create_capsule(capsule));
  };
  const double slant = std::sqrt(0.5);
  for (const double speed : speeds)
    for (const double b : {0.0, 0.5, 0.9}) {
      SCOPED_TRACE(testing::Message() << speed << " m/s, b/R " << b);
      const double chord = radius * std::sqrt(1 - b * b);
      const Vec line = centre + b * radius * across, side = line - chord * ahead;
      expect_stop(GetParam(), side, ahead, 0.2 * speed * dt, speed, create);
      expect_stop(GetParam(), side - 0.5 * half * beside, slant * (ahead + beside),
                  0.2 * speed * dt, speed, create);
      for (const double towards : {1.0, -1.0}) {  // either end
        const Vec end = line - towards * (half + chord) * beside;
        expect_stop(GetParam(), end, towards * beside, 0.2 * speed * dt, speed, create);
      }
    }
}

TEST_P(Sweep, ACylinderIsHitOnItsSideAndOnItsCaps) {
  const double radius = 0.02, half = 0.06;
  const auto create = [&](TestWorld& test) {
    weft::CylinderDesc cylinder;
    cylinder.a = to_weft(centre - half * beside);
    cylinder.b = to_weft(centre + half * beside);
    cylinder.radius = radius;
    test.take(test.world().create_cylinder(cylinder));
  };
  const double slant = std::sqrt(0.5);
  for (const double speed : speeds)
    for (const double b : {0.0, 0.5, 0.9}) {
      SCOPED_TRACE(testing::Message() << speed << " m/s, b/R " << b);
      const double chord = radius * std::sqrt(1 - b * b);
      const Vec line = centre + b * radius * across;
      expect_stop(GetParam(), line - chord * ahead, ahead, 0.2 * speed * dt, speed, create);
      expect_stop(GetParam(), line - chord * ahead - 0.5 * half * beside, slant * (ahead + beside),
                  0.2 * speed * dt, speed, create);
      for (const double end : {-1.0, 1.0})
        expect_stop(GetParam(), line + end * half * beside, -end * beside, 0.2 * speed * dt, speed,
                    create);
    }
}

constexpr Vec half_edges{0.03, 0.04, 0.05};

/// Face by face: the outward direction, one along the face, and the middle of the face.
template <class Use>
void for_each_face(Vec axis, double degrees, Use use) {
  const Vec edges[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const double half[] = {half_edges.x, half_edges.y, half_edges.z};
  for (int k = 0; k < 3; ++k)
    for (const double side : {-1.0, 1.0}) {
      SCOPED_TRACE(testing::Message() << (side < 0 ? "-" : "+") << "xyz"[k] << " face");
      const Vec out = turned(side * edges[k], axis, degrees);
      const Vec along = turned(edges[(k + 1) % 3], axis, degrees);
      use(out, along, centre + half[k] * out);
    }
}

void box_at_centre(TestWorld& test) {
  weft::BoxDesc box;
  box.center = to_weft(centre);
  box.half = to_weft(half_edges);
  box.axis = {1, 2, 2};
  box.degrees = 40;
  test.take(test.world().create_box(box));
}

TEST_P(Sweep, ABoxIsHitOnEachFaceStraightAndObliquely) {
  for (const double speed : speeds)
    for_each_face({1, 2, 2}, 40, [&](Vec out, Vec along, Vec middle) {
      for (const double b : {0.0, 0.01, -0.025})
        expect_stop(GetParam(), middle + b * along, -1 * out, 0.4 * speed * dt, speed,
                    box_at_centre);
      expect_stop(GetParam(), middle - 0.01 * along, 0.6 * along - 0.8 * out, 0.4 * speed * dt,
                  speed, box_at_centre);
    });
}

TEST_P(Sweep, AMeshIsHitOnEachFaceAtItsThickness) {
  const double thickness = 0.005;
  const auto create = [&](TestWorld& test) {
    weft::MeshColliderDesc desc;
    desc.pose = {{1, 2, 2}, 40, to_weft(centre)};
    add_collider(test, reference::box(half_edges), thickness, true, desc);
  };
  for (const double speed : speeds)
    for_each_face({1, 2, 2}, 40, [&](Vec out, Vec along, Vec middle) {
      const Vec hit = middle + thickness * out;
      for (const double b : {0.0, 0.01, -0.025})
        expect_stop(GetParam(), hit + b * along, -1 * out, 0.4 * speed * dt, speed, create);
      // Obliquely it is caught within a thickness of the way, at the height where it must stop.
      const Vec direction = 0.6 * along - 0.8 * out;
      const Vec x =
          after_flight(GetParam(), hit - 0.4 * speed * dt * direction, speed * direction, create);
      EXPECT_NEAR(dot(x - hit, out), 0, 1e-5 * speed * dt);
      EXPECT_LE(length(x - hit), thickness);
    });
}

TEST_P(Sweep, ASheetOfTrianglesIsHitFromBothSides) {
  const double thickness = 0.005;
  const auto create = [&](TestWorld& test) { add_collider(test, square(0.2), thickness, false); };
  for (const double speed : speeds)
    for (const double side : {-1.0, 1.0})
      for (const Vec at : {Vec{0.07, 0, -0.11}, Vec{0, 0, 0}, Vec{0.1, 0, 0.1}}) {
        const Vec hit = at + Vec{0, side * thickness, 0};
        expect_stop(GetParam(), hit, {0, -side, 0}, 0.4 * speed * dt, speed, create);
      }
}

TEST_P(Sweep, AFlightThatEndsJustInsideEndsOnTheSurfaceWhereItCame) {
  for (const double share : {0.3, 0.6, 0.9}) {  // of the radius, short of the centre's plane
    const double radius = 0.1, speed = 30, b = 0.5 * radius;
    const double chord = std::sqrt(radius * radius - b * b);
    const Vec end = centre + b * across - share * chord * ahead;
    const Vec x = after_flight(GetParam(), end - speed * dt * ahead, speed * ahead,
                               [&](TestWorld& test) { sphere_at_centre(test, radius); });
    EXPECT_NEAR(length(x - centre), radius, 1e-6);
    EXPECT_LE(dot(x - end, ahead), 0);
    EXPECT_LE(length(x - (centre + b * across - chord * ahead)), length(x - end) + chord);
  }
}

TEST_P(Sweep, AGrazingPassEitherSlidesOrMisses) {
  const double radius = 0.1, speed = 30;
  for (const double b : {0.991, 0.999, 0.99999, 1.0001, 1.5}) {
    const Vec start = centre + b * radius * across - 0.25 * ahead, end = start + 0.5 * ahead;
    const Vec x = after_flight(GetParam(), start, speed * ahead,
                               [&](TestWorld& test) { sphere_at_centre(test, radius); });
    const bool stopped = b < 1 && std::abs(length(x - centre) - radius) < 1e-6;
    if (!stopped) expect_near(x, end, 1e-6);
    EXPECT_TRUE(!stopped || b < 0.992) << b;
  }
  const double b = 0.98, chord = radius * std::sqrt(1 - b * b);
  expect_stop(GetParam(), centre + b * radius * across - chord * ahead, ahead, 0.2, speed,
              [&](TestWorld& test) { sphere_at_centre(test, radius); });
}

INSTANTIATE_TEST_SUITE_P(Precision, Sweep, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::sweep
