// Sets whose members turn: where they arrive, which sizes they may have, how planes tilt.
#include "reference/turning.h"

#include "weft/debug_draw.hpp"

namespace weft_tests::turning_sets {
namespace {

using TurningSets = BothPrecisions;

constexpr double dt = 1.0 / 64;

/// Ends of every line that debug_draw gives.
std::vector<Vec> lines(TestWorld& test) {
  std::vector<Vec> out;
  weft::DebugDraw draw;
  draw.what = weft::DebugDraw::colliders;
  draw.user = &out;
  draw.line = [](void* user, weft::double3 a, weft::double3 b, uint32_t) {
    static_cast<std::vector<Vec>*>(user)->push_back(from_weft(a));
    static_cast<std::vector<Vec>*>(user)->push_back(from_weft(b));
  };
  test.check(test.world().debug_draw(draw));
  return out;
}

TEST_P(TurningSets, LimbsOfASetArriveWhereTheyAreDescribedHoweverLongTheyTurn) {
  for (const Vec place : far_places) {
    TestWorld test(plain_world(GetParam()));
    const auto set = test.take(test.world().create_collider_set(Limbs(place, 0, false).desc()));
    for (int n = 1; n <= 3000; ++n) {
      const Limbs now(place, 7.3 * n, false);
      test.check(test.world().move_collider_set(set, now.desc()));
      test.step(dt);
      if (n % 500 != 0) continue;
      // Where the lines of the capsule along y run to.
      const Vec end = from_weft(now.capsules[1].b), start = from_weft(now.capsules[1].a);
      double nearest = 1e300, furthest = 0;
      const Vec axis = (1 / length(end - start)) * (end - start);
      for (const Vec p : lines(test)) {
        const Vec from = p - place - Vec{0.3, 0, 0};
        if (length(from) > 0.2502 + 1e-9) continue;  // of the others
        const double along = dot(from, axis);
        if (length(from - along * axis) < 0.0501) furthest = std::fmax(furthest, along);
      }
      for (const Vec p : lines(test))
        nearest = std::fmin(nearest, std::abs(length(p - end) - 0.05));
      EXPECT_LT(nearest, 1e-9) << n;
      EXPECT_GT(furthest, 0.2 - 1e-9);
    }
  }
}

TEST_P(TurningSets, BonesInFloatAreAcceptedAnywhere) {
  for (const Vec place : far_places) {
    TestWorld test(plain_world(GetParam()));
    const auto set = test.take(test.world().create_collider_set(Limbs(place, 0, true).desc()));
    for (int n = 1; n <= 400; ++n) {
      const Limbs now(place, 3.1 * n, true);
      ASSERT_EQ(test.world().move_collider_set(set, now.desc()), weft::Status::ok)
          << place.x << ": " << test.log();
    }
    // What rounding does not explain is refused, also there.
    const double four_ulps = 4 * std::ldexp(1.0, std::ilogb(length(place) + 1) - 23);
    Limbs longer(place, 0, false);
    longer.capsules[1].b.y += 1.1e-4 * 0.4 + 3 * four_ulps;
    EXPECT_EQ(test.world().move_collider_set(set, longer.desc()), weft::Status::invalid_argument);
    EXPECT_NE(test.log().find("capsules[1]: the length"), std::string::npos) << test.log();
    EXPECT_NE(test.log().find("may_stretch"), std::string::npos);
  }
}

TEST_P(TurningSets, OnlyWhatMayStretchTakesNewSizes) {
  TestWorld test(plain_world(GetParam())), made(plain_world(GetParam()));
  const Vec place{3, 4, 5};
  const auto set = test.take(test.world().create_collider_set(Limbs(place, 10, false).desc()));
  Limbs grown(place, 25, false, 1.5);
  weft::ColliderSetDesc desc = grown.desc();
  EXPECT_EQ(test.world().move_collider_set(set, desc), weft::Status::invalid_argument);
  desc.may_stretch = true;
  test.check(test.world().move_collider_set(set, desc, weft::Move::teleport));
  made.take(made.world().create_collider_set(grown.desc()));
  const weft::ClothId a = add_dust(test, place), b = add_dust(made, place);
  test.step(dt, 3);
  made.step(dt, 3);
  const std::vector<Vec> x = test.positions(a), y = made.positions(b);
  int touched = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    EXPECT_LE(length(x[i] - y[i]), 1e-5);
    touched += length(x[i] - place - dust()[i]) > 1e-3;
  }
  EXPECT_GT(touched, 20);
  grown.spheres[0].radius = 0;
  desc = grown.desc();
  desc.may_stretch = true;
  test.clear_log();
  EXPECT_EQ(test.world().move_collider_set(set, desc), weft::Status::invalid_argument);
  EXPECT_NE(test.log().find("spheres[0]: sphere.radius is 0"), std::string::npos) << test.log();
}

/// A plane of a set that tilts goes about the line where it meets its new place: what lies on it
/// next to that line stays, at any distance from the origin.
TEST_P(TurningSets, APlaneOfASetTiltsAboutTheLineWhereItMeetsItsNewPlace) {
  for (const Vec place : far_places) {
    SCOPED_TRACE(place.x);
    weft::WorldDesc desc = plain_world(GetParam());
    desc.substeps = 8;
    TestWorld test(desc);
    const weft::ClothId cloth = add_dust(test, place);
    weft::PlaneDesc plane;
    const Vec foot = place + Vec{0, -0.7, 0};
    const auto tilted = [&](double degrees) {
      const Vec normal = turned({0, 1, 0}, {0, 0, 1}, degrees);
      plane.normal = to_weft(normal);
      plane.offset = dot(normal, foot);
      weft::ColliderSetDesc set;
      set.planes = weft::View<weft::PlaneDesc>(&plane, 1);
      return set;
    };
    const auto set = test.take(test.world().create_collider_set(tilted(0)));
    for (int n = 1; n <= 10; ++n) {
      test.check(test.world().move_collider_set(set, tilted(4.5 * n)));
      test.step(dt);
    }
    const std::vector<Vec> x = test.positions(cloth), was = dust();
    const Vec normal = turned({0, 1, 0}, {0, 0, 1}, 45);
    int stayed = 0, moved = 0;
    for (size_t i = 0; i < x.size(); ++i) {
      const double above = dot(x[i] - foot, normal), before = dot(was[i] + Vec{0, 0.7, 0}, normal);
      EXPECT_GE(above, -1e-4);
      const double way = length(x[i] - place - was[i]);
      const bool outside = before > 0.01 && was[i].y > -0.69;  // of all places on the way
      if (outside) {
        EXPECT_LT(way, 1e-6) << i;
      }
      stayed += outside;
      moved += before < -0.01 && way > 0.005;
    }
    EXPECT_GT(stayed, 100);
    EXPECT_GT(moved, 20);
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, TurningSets, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::turning_sets
