// Shapes that are grown, and shapes that are looked at where they are now: against their points.
#include "kernels/placement.h"
#include "kernels/colliders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "reference/random.h"

namespace weft {
using namespace WEFT_BACKEND_NS;

namespace {

using Vector = Vec3<double>;

Vector any(reference::SplitMix& random, double size) {
  const auto one = [&] { return size * (2 * random.uniform() - 1); };
  const double x = one(), y = one(), z = one();
  return {x, y, z};
}
Vector unit_of(Vector v) { return (1 / std::sqrt(dot(v, v))) * v; }

/// Rows of a rotation by Rodrigues' formula.
Mat3<double> rotation(Vector k, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto row = [&](double a, Vector e, Vector crossed) {
    return c * e + s * crossed + ((1 - c) * a) * k;
  };
  return {{row(k.x, {1, 0, 0}, {0, -k.z, k.y}), row(k.y, {0, 1, 0}, {k.z, 0, -k.x}),
           row(k.z, {0, 0, 1}, {-k.y, k.x, 0})}};
}

template <class Use>
void with_every_shape(Use use) {
  const Vector a{0.3, -0.2, 0.1}, axis = unit_of({2, 3, 6}), side = unit_of({6, 2, -3}),
                                  third = cross(axis, side);
  Sphere<double> sphere{};
  sphere.center = a;
  sphere.radius = 0.4;
  use(sphere);
  Plane<double> plane{};
  plane.normal = axis;
  plane.offset = 0.1;
  use(plane);
  Capsule<double> capsule{};
  capsule.a = a;
  capsule.axis = 0.6 * axis;
  capsule.inverse_length2 = 1 / 0.36;
  capsule.radius = 0.25;
  capsule.side = side;
  use(capsule);
  Cylinder<double> cylinder{};
  cylinder.a = a;
  cylinder.axis = axis;
  cylinder.length = 0.6;
  cylinder.radius = 0.3;
  cylinder.side = side;
  use(cylinder);
  Box<double> box{};
  box.center = a;
  box.axis[0] = axis;
  box.axis[1] = side;
  box.axis[2] = third;
  box.half = {0.5, 0.2, 0.35};
  use(box);
}

/// Whoever is nearer to a point inside than what it is grown by is inside.
TEST(Placement, AShapeThatIsGrownHoldsAllThatIsAroundIt) {
  with_every_shape([](const auto& shape) {
    reference::SplitMix random{7};
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vector x = any(random, 1.2), near = x + 0.0999 * unit_of(any(random, 1));
      if (!is_inside(shape, x)) continue;
      ++inside;
      ASSERT_TRUE(is_inside(grown(shape, 0.1), near)) << i;
    }
    EXPECT_GT(inside, 100);
  });
}

/// A point is in the shape that has turned and moved if and only if, taken back, it is in it.
TEST(Placement, WhereAShapeIsNowIsWhereItsPointsAre) {
  reference::SplitMix random{11};
  for (int turn = 0; turn < 20; ++turn) {
    const Turned<double> placed{rotation(unit_of(any(random, 1)), 3 * random.uniform()),
                                any(random, 0.5), any(random, 0.5)};
    with_every_shape([&](const auto& shape) {
      for (int i = 0; i < 1000; ++i) {
        const Vector start = any(random, 1);
        const Vector now = placed.turn * (start - placed.pivot) + (placed.pivot + placed.by);
        ASSERT_EQ(is_inside(at_present(placed, shape), now), is_inside(shape, start)) << i;
        const Vector back = at_start(placed, now) - start;
        ASSERT_LT(std::sqrt(dot(back, back)), 1e-14);
      }
    });
  }
}

}  // namespace
}  // namespace weft
