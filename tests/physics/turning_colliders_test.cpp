// Colliders that turn: about their own middle, which goes straight, by the shorter way, as far from
// the world's origin as one likes. What they touch is compared with closed forms in double
// precision.
#include "reference/effects.h"

#include "weft/debug_draw.hpp"

namespace weft_tests::turning_colliders {
namespace {

using Turning = BothPrecisions;

constexpr double dt = 1.0 / 64, size = 0.2;
constexpr uint32_t substeps = 64;  // so many that nothing is swept: half a turn is 0.03 m in each
constexpr Vec places[] = {{0, 0, 0}, {5000, 0, 0}, {0, -5000, 3}, {0, 0, 1e5}, {-1e5, 7e4, 1e5}};

/// Signed distance to what add_body makes, from its middle and in its own frame.
double distance(Body body, Vec p) {
  const double out = std::hypot(p.x, p.z);
  switch (body) {
    case Body::sphere:
      return length(p) - size;
    case Body::plane:
      return p.y;  // from the point that it is turned about
    case Body::capsule:
      return length(p - Vec{std::fmin(size, std::fmax(-size, p.x)), 0, 0}) - size;
    case Body::cylinder:
      return std::fmax(out, std::abs(p.y)) - size;
    case Body::box:
    case Body::mesh:
      break;
  }
  return std::fmax(std::abs(p.x), std::fmax(std::abs(p.y), std::abs(p.z))) - size;
}

/// Loose particles about a place, in a lattice that no axis favours.
std::vector<Vec> dust() {
  std::vector<Vec> at;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      for (int k = -4; k <= 4; ++k)
        at.push_back(0.113 * (double(i) * ahead + double(j) * across + double(k) * beside));
  return at;
}
weft::ClothId add_dust(TestWorld& test, Vec place) {
  const std::vector<weft::double3> points = to_weft(dust());
  weft::NetworkDesc desc;
  desc.positions = weft::View<weft::double3>(points);
  desc.material.mass.value = double(points.size());
  weft::ClothDesc cloth;
  cloth.pose.translate = to_weft(place);
  return test.add(desc, cloth);
}

/// Half a length that says how a lattice point fares: below, it is touched; above, it is not.
struct Fate {
  double nearest = 1e300;
  bool touched(Body body) const { return nearest < (body == Body::mesh ? -0.03 : -1e-4); }
  bool missed() const { return nearest > 1e-4; }
};
/// Of every point, from where the body is at the end of each substep.
std::vector<Fate> fates(Body body, Vec middle, Vec by, Vec axis, double degrees) {
  std::vector<Fate> all;
  for (const Vec x : dust()) {
    Fate fate;
    for (uint32_t s = 1; s <= substeps; ++s) {
      const double t = double(s) / substeps;
      const Vec p = turned(x - (middle + t * by), axis, -t * degrees);
      fate.nearest = std::fmin(fate.nearest, distance(body, p));
    }
    all.push_back(fate);
  }
  return all;
}

/// The pose that turns about `pivot` and then moves by `by`.
weft::Pose about(Vec pivot, Vec by, Vec axis, double degrees) {
  return {to_weft(axis), degrees, to_weft(pivot + by - turned(pivot, axis, degrees))};
}

TEST_P(Turning, TouchesWhatLiesOnTheWayOfItsShapeAndNothingElse) {
  for (const Body body : every_body)
    for (const Vec axis : {Vec{0, 0, 1}, Vec{0, 1, 0}, Vec{1, 2, -3}})
      for (const double degrees : {20.0, -75.0, 180.0})
        for (const Vec by : {Vec{0, 0, 0}, Vec{0.15, -0.1, 0.05}}) {
          // A plane turns about its point next to the cloth; the bodies lie half out of the dust.
          const Vec middle = body == Body::plane ? Vec{0, -0.42, 0} : Vec{0.3, -0.2, 0.1};
          const std::vector<Fate> expected = fates(body, middle, by, axis, degrees);
          const Vec top = body == Body::plane ? middle : middle + Vec{0, size, 0};
          for (const Vec place : places) {
            SCOPED_TRACE(testing::Message() << name(body) << " " << degrees << " at " << place.x);
            weft::WorldDesc desc = plain_world(GetParam());
            desc.substeps = substeps;
            TestWorld test(desc);
            const weft::ClothId cloth = add_dust(test, place);
            const weft::ColliderId id = add_body(test, body, place + top, size);
            const std::vector<Vec> before = test.positions(cloth);
            // What begins inside is none of this test's business.
            std::vector<Vec> inside;
            for (const Vec x : dust()) inside.push_back(x - middle);
            test.check(test.world().move_collider(id, about(place + middle, by, axis, degrees)));
            test.step(dt);
            const std::vector<Vec> after = test.positions(cloth);
            int touched = 0, missed = 0;
            for (size_t i = 0; i < after.size(); ++i) {
              if (distance(body, inside[i]) < 1e-4) continue;
              const bool moved = length(after[i] - before[i]) > 1e-12 * length(place) + 1e-7;
              if (expected[i].touched(body)) {
                ++touched;
                ASSERT_TRUE(moved) << i << ": " << expected[i].nearest;
              } else if (expected[i].missed()) {
                ++missed;
                ASSERT_FALSE(moved) << i << ": " << expected[i].nearest;
              }
            }
            if (body != Body::plane) {
              EXPECT_GT(missed, 50);
            }
            // Some turns take a shape into itself.
            const bool itself = body == Body::sphere || body == Body::plane || length(by) == 0;
            if (!itself) {
              EXPECT_GT(touched, 1);
            }
          }
        }
}

TEST_P(Turning, PushesAlikeAtAnyDistanceFromTheOrigin) {
  const double within = GetParam() == weft::Precision::float64 ? 1e-9 : 1e-5;
  for (const Body body : every_body) {
    std::vector<Vec> expected;
    for (const Vec place : places) {
      SCOPED_TRACE(testing::Message() << name(body) << " at " << place.x);
      weft::WorldDesc desc = plain_world(GetParam());
      desc.substeps = 8;
      TestWorld test(desc);
      const weft::ClothId cloth = add_dust(test, place);
      const Vec middle = body == Body::plane ? Vec{0, -0.3, 0} : Vec{0.3, -0.2, 0.1};
      const Vec top = body == Body::plane ? middle : middle + Vec{0, size, 0};
      const weft::ColliderId id = add_body(test, body, place + top, size, 0.4);
      for (int n = 1; n <= 12; ++n) {
        test.check(test.world().move_collider(
            id, about(place + middle, n * Vec{0.004, 0.01, 0}, {1, -2, 0.5}, 7.0 * n)));
        test.step(1.0 / 60);
      }
      std::vector<Vec> x = test.positions(cloth);
      for (Vec& p : x) p -= place;
      if (expected.empty()) expected = x;
      // A position far away has the rounding of the world's coordinates.
      const double rounding = 4e-16 * length(place) * (GetParam() == weft::Precision::float64);
      double most = 0;
      for (size_t i = 0; i < x.size(); ++i) most = std::fmax(most, length(x[i] - expected[i]));
      EXPECT_LE(most, within * size + 20 * rounding);
    }
  }
}

/// Three descriptions of each shape in a set, of which `angle` turns all about their own middles.
struct Limbs {
  Limbs(Vec place, double angle, bool in_float, double scale = 1) {
    const auto put = [&](Vec v) {
      v = place + v;
      return in_float ? to_weft(reference::through_float(v)) : to_weft(v);
    };
    const auto rod = [&](auto& rods, Vec middle, Vec axis, double half) {
      typename std::decay_t<decltype(rods)>::value_type d;
      const Vec along = turned(half * scale * axis, {1, 2, 3}, angle);
      d.a = put(middle - along);
      d.b = put(middle + along);
      d.radius = 0.05 * scale;
      rods.push_back(d);
    };
    rod(capsules, {-0.3, 0, 0}, ahead, 0.15);
    rod(capsules, {0.3, 0, 0}, {0, 1, 0}, 0.2);
    rod(cylinders, {0, 0, 0.3}, across, 0.12);
    weft::BoxDesc box;
    box.center = put({0, 0, -0.3});
    box.half = {0.1 * scale, 0.05 * scale, 0.02 * scale};
    box.axis = {1, 2, 3};
    box.degrees = angle;
    boxes.push_back(box);
    weft::SphereDesc sphere;
    sphere.center = put({0, 0.1, 0});
    sphere.radius = 0.07 * scale;
    spheres.push_back(sphere);
  }
  weft::ColliderSetDesc desc() const {
    weft::ColliderSetDesc d;
    d.spheres = spheres;
    d.capsules = capsules;
    d.cylinders = cylinders;
    d.boxes = boxes;
    return d;
  }
  std::vector<weft::SphereDesc> spheres;
  std::vector<weft::CapsuleDesc> capsules;
  std::vector<weft::CylinderDesc> cylinders;
  std::vector<weft::BoxDesc> boxes;
};

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

TEST_P(Turning, LimbsOfASetArriveWhereTheyAreDescribedHoweverLongTheyTurn) {
  for (const Vec place : places) {
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

TEST_P(Turning, BonesInFloatAreAcceptedAnywhere) {
  for (const Vec place : places) {
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

TEST_P(Turning, OnlyWhatMayStretchTakesNewSizes) {
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
TEST_P(Turning, APlaneOfASetTiltsAboutTheLineWhereItMeetsItsNewPlace) {
  for (const Vec place : places) {
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

INSTANTIATE_TEST_SUITE_P(Precision, Turning, both_precisions(), precision_name);

/// A sheet at rest that sleeps, and colliders that turn in and out of its reach.
class TurningAndSleep : public testing::TestWithParam<double> {
 protected:
  TurningAndSleep() : test(still()), id(add_sheet(test)) {}
  static weft::ClothId add_sheet(TestWorld& test) {
    weft::GridDesc grid;
    grid.rows = grid.columns = 9;
    const std::vector<weft::Pin> pins{{0}, {8}, {72}, {80}};
    weft::ClothDesc cloth;
    cloth.pins = pins;
    cloth.pose.translate = {GetParam() - 0.5, -0.5, 0};
    cloth.sleep_speed = 0.01;
    cloth.sleep_time = 0.1;
    return test.add(grid, cloth);
  }
  static weft::WorldDesc still() {
    weft::WorldDesc desc;
    desc.gravity = {0, 0, 0};
    return desc;
  }
  bool asleep() { return test.take(test.world().asleep(id)); }
  TestWorld test;
  weft::ClothId id;
};

TEST_P(TurningAndSleep, WhatTurnsOutOfReachWakesNobody) {
  const Vec place{GetParam(), 0, 0};
  std::vector<weft::ColliderId> far;
  for (const Body body : every_body) far.push_back(add_body(test, body, place - Vec{0, 3, 0}, 0.3));
  test.step(dt, 20);
  ASSERT_TRUE(asleep());
  for (int n = 1; n <= 40; ++n) {
    for (const weft::ColliderId collider : far)
      test.check(test.world().move_collider(
          collider, about(place - Vec{0, 3.3, 0}, {0, 0, 0}, {1, 0, 1}, 2.0 * (n % 5))));
    test.step(dt);
    ASSERT_TRUE(asleep()) << n;
  }
}

TEST_P(TurningAndSleep, WhatTurnsIntoItWakesItAndEqualInputDoesNot) {
  const Vec place{GetParam(), 0, 0};
  for (const Body body : every_body) {
    if (body == Body::sphere) continue;  // turns into itself
    SCOPED_TRACE(name(body));
    TestWorld fresh(still());
    const weft::ClothId sheet = add_sheet(fresh);
    const auto sleeps = [&] { return fresh.take(fresh.world().asleep(sheet)); };
    // Below the sheet's plane z = 0 until a quarter of a turn brings it up.
    const Vec middle = place + Vec{0, 0, -0.3};
    const weft::ColliderId one = add_body(fresh, body, middle + Vec{0, 0.28, 0}, 0.28);
    const weft::Pose away = about(middle, {0, 0, -0.2}, {0, 0, 1}, 0);
    if (body == Body::plane) {
      fresh.check(fresh.world().move_collider(one, about(place, {0, -9, 0}, {0, 0, 1}, 0),
                                              weft::Move::teleport));
    } else {
      fresh.check(fresh.world().move_collider(one, away, weft::Move::teleport));
    }
    fresh.step(dt, 30);
    ASSERT_TRUE(sleeps());
    const weft::Pose still = body == Body::plane ? about(place, {0, -9, 0}, {0, 0, 1}, 0) : away;
    for (int n = 0; n < 3; ++n) {
      fresh.check(fresh.world().move_collider(one, still));
      fresh.step(dt);
      EXPECT_TRUE(sleeps()) << "equal input";
    }
    const weft::Pose up = body == Body::plane ? about(place, {0, -9, 0}, {0, 0, 1}, 170)
                                              : about(middle, {0, 0, 0.1}, {0, 1, 0}, 80);
    fresh.check(fresh.world().move_collider(one, up));
    fresh.step(dt);
    EXPECT_FALSE(sleeps());
  }
}

TEST_P(TurningAndSleep, ASetThatIsSentAgainWakesNobodyAndASizeThatReachesItDoes) {
  const Vec place{GetParam(), 0, -0.4};
  const auto set = test.take(test.world().create_collider_set(Limbs(place, 33, true).desc()));
  test.step(dt, 20);
  const Limbs turned_on(place, 47, true);
  weft::ColliderSetDesc sent = turned_on.desc();
  sent.may_stretch = true;  // in float each bone has another length
  test.check(test.world().move_collider_set(set, sent));
  test.step(dt, 20);
  ASSERT_TRUE(asleep());
  for (const bool may_stretch : {false, true, false}) {
    const Limbs same(place, 47, true);
    weft::ColliderSetDesc desc = same.desc();
    desc.may_stretch = may_stretch;
    test.check(test.world().move_collider_set(set, desc));
    test.step(dt);
    EXPECT_TRUE(asleep());
  }
  const Limbs large(place, 47, true, 3);
  weft::ColliderSetDesc desc = large.desc();
  desc.may_stretch = true;
  test.check(test.world().move_collider_set(set, desc));
  EXPECT_FALSE(asleep());
}

INSTANTIATE_TEST_SUITE_P(At, TurningAndSleep, testing::Values(0.0, 5000.0, 1e5));

/// Beyond the 64 entries of a block's mask, and out of reach: what is left out never changes a bit.
TEST(TurningLists, WhatTurnsOutOfReachChangesNoBit) {
  for (const auto precision : {weft::Precision::float32, weft::Precision::float64})
    for (const auto form : {weft::Form::summed, weft::Form::position}) {
      weft::WorldDesc desc;
      desc.precision = precision;
      desc.form = form;
      desc.substeps = 24;
      TestWorld few(desc), many(desc);
      weft::GridDesc grid;
      grid.rows = 19;
      grid.columns = 21;
      const std::vector<weft::Pin> pins{{0}, {20}};
      weft::ClothDesc cloth;
      cloth.pins = pins;
      const weft::ClothId a = few.add(grid, cloth), b = many.add(grid, cloth);
      std::vector<std::pair<weft::ColliderId, weft::ColliderId>> near;
      std::vector<weft::ColliderId> far;
      for (const Body body : every_body) {
        for (int i = 0; i < 12; ++i)
          far.push_back(add_body(many, body, {8.0 + 3 * i, -1.5 * i - 8, 4}, 0.3));
        const Vec at{0.1 * int(body), 0.1 + 0.1 * int(body), 0.3};
        const Vec top = body == Body::plane ? Vec{0, -0.7, 0} : at;
        near.emplace_back(add_body(few, body, top, 0.12, 0.3),
                          add_body(many, body, top, 0.12, 0.3));
      }
      for (int n = 1; n <= 40; ++n) {
        const auto turn = [&](Vec at) { return about(at, {0, 0, -0.01 * n}, {1, 1, 3}, 9.0 * n); };
        int i = 0;
        for (const auto& [c, d] : near) {
          const Vec at = i == int(Body::plane) ? Vec{0, -0.7, 0} : Vec{0.1 * i, 0.1 * i, 0.3};
          const weft::Pose pose =
              i == int(Body::plane) ? about(at, {0, 0, 0}, {1, 0, 0}, 2.0 * (n % 3)) : turn(at);
          ++i;
          few.check(few.world().move_collider(c, pose));
          many.check(many.world().move_collider(d, pose));
        }
        for (size_t k = 0; k < far.size(); ++k) {
          if (k / 12 == size_t(Body::plane)) continue;
          many.check(many.world().move_collider(far[k], turn({30, 0, 0})));
        }
        few.step(1.0 / 60);
        many.step(1.0 / 60);
        const std::vector<Vec> x = few.positions(a), y = many.positions(b);
        for (size_t v = 0; v < x.size(); ++v) ASSERT_TRUE(same_bits(x[v], y[v])) << n << " " << v;
      }
    }
}

}  // namespace
}  // namespace weft_tests::turning_colliders
