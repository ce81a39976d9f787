// The box that a collider sweeps through in a frame, against points of its surface on their own
// ways; and the ways of planes and boxes to new descriptions.
#include "api/records/collider.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "api/context/vector_math.h"

namespace weft_tests {
namespace {

using namespace weft;
using namespace weft::api;

constexpr double pi = 3.14159265358979323846;
constexpr double3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}, {-3, 1, 2}, {2, -3, 0.1}};

double3 unit(const double3& v) { return times(1 / length(v), v); }
/// Rodrigues' formula, about a unit vector.
double3 rodrigues(const double3& v, const double3& k, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return plus(plus(times(c, v), times(s, outer(k, v))), times((1 - c) * inner(k, v), k));
}
double3 some_across(const double3& axis) {
  return unit(outer(axis, std::fabs(axis.x) < 0.6 ? double3{1, 0, 0} : double3{0, 1, 0}));
}

/// A shape, its middle, and points that reach as far as it does; `around`: what is round about
/// them.
struct Sample {
  ColliderRecord record;
  double3 middle;
  std::vector<double3> points;
  double around;
};

std::vector<Sample> samples(const double3& middle, const double3& along) {
  std::vector<Sample> all;
  const double3 half = times(0.7, unit(along)), u = some_across(unit(along)),
                v = outer(unit(along), u);
  CapsuleDesc capsule;
  capsule.a = minus(middle, half);
  capsule.b = plus(middle, half);
  capsule.radius = 0.2;
  all.push_back({record_of(capsule), middle, {capsule.a, capsule.b}, 0.2});
  CylinderDesc cylinder;
  cylinder.a = capsule.a;
  cylinder.b = capsule.b;
  cylinder.radius = 0.3;
  Sample rims{record_of(cylinder), middle, {}, 0};
  for (int k = 0; k < 32; ++k) {
    const double3 out =
        plus(times(0.3 * std::cos(2 * pi * k / 32), u), times(0.3 * std::sin(2 * pi * k / 32), v));
    rims.points.push_back(plus(cylinder.a, out));
    rims.points.push_back(plus(cylinder.b, out));
  }
  all.push_back(rims);
  BoxDesc box;
  box.center = middle;
  box.half = {0.6, 0.1, 0.3};
  box.axis = along;
  box.degrees = 50;
  Sample corners{record_of(box), middle, {}, 0};
  for (int k = 0; k < 8; ++k) {
    const double3 corner{k & 1 ? 0.6 : -0.6, k & 2 ? 0.1 : -0.1, k & 4 ? 0.3 : -0.3};
    corners.points.push_back(plus(middle, rodrigues(corner, unit(along), 50 * pi / 180)));
  }
  all.push_back(corners);
  SphereDesc sphere;
  sphere.center = middle;
  sphere.radius = 0.4;
  all.push_back({record_of(sphere), middle, {middle}, 0.4});
  return all;
}

TEST(SweptBounds, HoldEveryPointOfEveryShapeOnItsWay) {
  for (const double3& middle : {double3{0, 0, 0}, {5000, -3, 2e4}})
    for (const double3& along : axes)
      for (const double3& axis : axes)
        for (const double degrees : {0.0, 3.0, -40.0, 90.0, 135.0, 175.0})
          for (const double3& by : {double3{0, 0, 0}, {0.4, -0.1, 0.2}, {-0.3, 0.5, -0.6}}) {
            const double angle = degrees * pi / 180;
            for (Sample s : samples(middle, along)) {
              Pose pose;
              pose.axis = axis;
              pose.degrees = degrees;
              const double3 moved = rodrigues(middle, unit(axis), angle);
              pose.translate = plus(minus(middle, moved), by);
              s.record.target = after(placed_by(pose, "pose"), s.record.described);
              s.record.gliding = true;
              const SweptBounds bounds = swept_bounds(s.record, path_of(s.record, 0, 0.1));
              const double hair = 1e-12 * (1 + length(middle));
              ASSERT_EQ(bounds.radius, s.around);
              double3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
              for (int k = 0; k <= 24; ++k) {
                const double t = k / 24.0;
                for (const double3& p : s.points) {
                  const double3 x = plus(plus(s.middle, times(t, by)),
                                         rodrigues(minus(p, s.middle), unit(axis), t * angle));
                  low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
                  high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
                }
              }
              for (const auto of : {&double3::x, &double3::y, &double3::z}) {
                ASSERT_LE(bounds.low.*of, low.*of + hair) << int(s.record.shape) << " " << degrees;
                ASSERT_GE(bounds.high.*of, high.*of - hair)
                    << int(s.record.shape) << " " << degrees;
                if (degrees != 0) continue;
                // A disc reaches between the points of its rim that are looked at.
                const double gap = s.record.shape == ColliderShape::cylinder ? 2e-3 : hair;
                ASSERT_GE(bounds.low.*of, low.*of - gap) << int(s.record.shape);
                ASSERT_LE(bounds.high.*of, high.*of + gap) << int(s.record.shape);
              }
            }
          }
}

/// A plane that is described anew is there at the end, however far it turned.
TEST(MotionTo, APlaneArrivesWhereItIsDescribed) {
  for (const double3& first : axes)
    for (const double3& axis : axes)
      for (const double degrees : {0.0, 5.0, 60.0, 91.0, 120.0, 179.0, 180.0, -100.0})
        for (const double offset : {-2.0, 0.0, 0.5, 3.0}) {
          PlaneDesc was, now;
          was.normal = first;
          was.offset = 0.7;
          now.normal = rodrigues(unit(first), unit(axis), degrees * pi / 180);
          now.offset = offset;
          const ColliderRecord plane = record_of(was), other = record_of(now);
          const Placed end = motion_to(plane, plane.placed, other);
          EXPECT_NEAR(length(minus(rotate(end.rows, plane.normal), other.normal)), 0, 1e-12);
          EXPECT_NEAR(inner(other.normal, end.translate), offset, 1e-12) << degrees;
        }
}

TEST(MotionTo, ABoxArrivesWhereItIsDescribedHoweverFarItTurned) {
  for (const double3& first : axes)
    for (const double3& axis : axes)
      for (const double degrees : {1.0, 89.0, 121.0, 150.0, 179.0, 180.0, -170.0}) {
        BoxDesc was, now;
        was.axis = first;
        was.degrees = 33;
        now.axis = axis;
        now.degrees = degrees;
        const ColliderRecord box = record_of(was), other = record_of(now);
        const Placed end = motion_to(box, box.placed, other);
        for (int e = 0; e < 3; ++e) {
          EXPECT_NEAR(length(minus(rotate(end.rows, box.edges[e]), other.edges[e])), 0, 1e-12)
              << e << " " << degrees;
        }
      }
}

}  // namespace
}  // namespace weft_tests
