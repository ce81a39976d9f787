// Colliders that turn: about their own middle, which goes straight, by the shorter way, as far from
// the world's origin as one likes. What they touch is compared with closed forms in double
// precision.
#include "reference/turning.h"

namespace weft_tests::turning_colliders {
namespace {

using Turning = BothPrecisions;

constexpr double dt = 1.0 / 64, size = 0.2;
constexpr uint32_t substeps = 64;  // so many that nothing is swept: half a turn is 0.03 m in each

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

TEST_P(Turning, TouchesWhatLiesOnTheWayOfItsShapeAndNothingElse) {
  for (const Body body : every_body)
    for (const Vec axis : {Vec{0, 0, 1}, Vec{0, 1, 0}, Vec{1, 2, -3}})
      for (const double degrees : {20.0, -75.0, 180.0})
        for (const Vec by : {Vec{0, 0, 0}, Vec{0.15, -0.1, 0.05}}) {
          // A plane turns about its point next to the cloth; the bodies lie half out of the dust.
          const Vec middle = body == Body::plane ? Vec{0, -0.42, 0} : Vec{0.3, -0.2, 0.1};
          const std::vector<Fate> expected = fates(body, middle, by, axis, degrees);
          const Vec top = body == Body::plane ? middle : middle + Vec{0, size, 0};
          for (const Vec place : far_places) {
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
    for (const Vec place : far_places) {
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

INSTANTIATE_TEST_SUITE_P(Precision, Turning, both_precisions(), precision_name);

}  // namespace
}  // namespace weft_tests::turning_colliders
