// Where a collider is on its way between two places: against angles and screws in closed form.
#include "api/records/collider_motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace weft_tests {
namespace {

using namespace weft;
using namespace weft::api;

constexpr double degree = 0.017453292519943295;

/// Rodrigues' formula, about a unit vector.
double3 rodrigues(const double3& v, const double3& k, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return plus(plus(times(c, v), times(s, outer(k, v))), times((1 - c) * inner(k, v), k));
}
double away(const double3& a, const double3& b) { return length(minus(a, b)); }
double3 unit(const double3& v) { return times(1 / length(v), v); }
constexpr double3 some_axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.36, -0.48, 0.8}, {-1, 2, 3}};

TEST(ColliderWay, TurnsUniformlyByTheShorterWayAboutAMiddleThatGoesStraight) {
  for (const double far : {0.0, 5e3, 1e5}) {
    for (const double3& axis : some_axes) {
      for (const double degrees : {1e-7, 0.3, 20.0, 90.0, 179.0, 180.0, 181.0, 340.0, -70.0}) {
        const Placed base = placed_by({{3, 1, 2}, 77, {0, 0, 0}}, "pose");
        Placed from = base, to = after(placed_by({axis, degrees, {0, 0, 0}}, "pose"), base);
        from.translate = {far, -far, 1};
        to.translate = {far + 0.3, -far, 1.7};
        const double shorter = degrees > 180 ? degrees - 360 : degrees;
        for (const double t : {1e-3, 0.25, 1.0 / 3, 0.5, 0.875}) {
          const Placed now = between(from, to, t);
          EXPECT_LT(away(now.translate, {far + t * 0.3, -far, 1 + t * 0.7}), 3e-16 * (1 + far));
          for (const double3& v : some_axes) {
            const double3 expected =
                rodrigues(rotate(base.rows, v), unit(axis), t * shorter * degree);
            EXPECT_LT(away(rotate(now.rows, v), expected), 1e-14) << degrees << " " << t;
          }
        }
      }
    }
  }
}

TEST(ColliderWay, IsExactAtBothEnds) {
  const Placed from = placed_by({{1, 2, 3}, 40, {1e5, 2, 3}}, "pose");
  const Placed to = placed_by({{3, -2, 1}, 130, {1e5, 0.1, 1 / 3.0}}, "pose");
  EXPECT_TRUE(same_place(between(from, to, 0), from));
  EXPECT_TRUE(same_place(between(from, to, 1), to));
  for (const double t : {0.1, 1.0 / 3, 0.7}) EXPECT_TRUE(same_place(between(to, to, t), to));
}

TEST(ColliderWay, TwoWaysOneAfterTheOtherAreTheWholeWay) {
  const Placed from = placed_by({{1, 2, 3}, 40, {-2, 2, 3}}, "pose");
  const Placed to = placed_by({{3, -2, 1}, 130, {-2, 0.1, 1 / 3.0}}, "pose");
  const Placed first = between(from, to, 0.4), both = between(first, to, 0.25);
  const Placed whole = between(from, to, 0.4 + 0.6 * 0.25);
  for (int r = 0; r < 3; ++r) EXPECT_LT(away(both.rows[r], whole.rows[r]), 1e-14);
  EXPECT_LT(away(both.translate, whole.translate), 1e-14);
}

TEST(ColliderWay, OfAPlaneIsAScrewThatAnyOfItsPointsTells) {
  for (const double degrees : {1e-6, 1e-3, 5.0, 90.0, 179.0}) {
    const double3 k = unit({1, -2, 0.5}), foot{40, 3, -7};
    const double pitch = 0.2;
    // The screw's closed form: about the axis through `foot` along k, and on along it.
    const auto screwed = [&](const double3& x, double t) {
      return plus(foot,
                  plus(rodrigues(minus(x, foot), k, t * degrees * degree), times(t * pitch, k)));
    };
    for (const double3& seen : {double3{0, 0, 0}, double3{900, -50, 3}, foot}) {
      Placed from, to = placed_by({k, degrees, {0, 0, 0}}, "pose");
      from.endless = to.endless = true;
      from.translate = seen;
      to.translate = screwed(seen, 1);
      for (const double t : {0.2, 0.5, 2.0 / 3}) {
        const Placed now = between(from, to, t);
        EXPECT_LT(away(now.translate, screwed(seen, t)), 1e-12 * (1 + length(seen))) << degrees;
        EXPECT_TRUE(now.endless);
      }
    }
  }
}

TEST(ColliderWay, InPartsIsTheSameTurnAndEndsWhereItShould) {
  for (const int parts : {1, 2, 7, 64, 1000}) {
    const Placed from = placed_by({{1, 0, 2}, 25, {0, 0, 0}}, "pose");
    const Placed to = placed_by({{2, 1, 0}, 160, {0, 0, 0}}, "pose");
    TurnInParts turn(from, to, parts);
    for (int i = 1; i <= parts; ++i) {
      double n[9];
      turn.next(n);
      const double3 rows[3] = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}};
      const Placed now = between(from, to, double(i) / parts);
      for (const double3& v : some_axes) {
        EXPECT_LT(away(rotate(rows, rotate(from.rows, v)), rotate(now.rows, v)), 1e-12);
      }
    }
  }
}

TEST(ColliderWay, FromOneDirectionToAnotherArrivesAlsoNextToHalfATurn) {
  for (const double3& a : some_axes) {
    for (const double off : {0.0, 1e-12, 1e-9, 1e-7, 1e-6, 2e-6, 1e-5, 1e-3, 1.0, 3.0}) {
      const double3 from = unit(a);
      const double3 side = unit(outer(from, {0.2, 0.3, -0.9}));
      const double3 to = rodrigues(times(-1, from), unit(outer(from, side)), off);
      EXPECT_LT(away(rotate(turn_from_to(from, to, side).rows, from), to), 3e-10) << off;
    }
  }
}

}  // namespace
}  // namespace weft_tests
