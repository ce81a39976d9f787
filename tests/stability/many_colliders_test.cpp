// Sheets on hundreds of colliders, and on a closed mesh: nothing is left inside.
#include "reference/effects.h"

namespace weft_tests {
namespace {

using ManyColliders = BothPrecisions;

constexpr double size = 0.012;

/// Signed distance in double precision to what add_body makes.
double distance(Body body, Vec top, Vec x) {
  const Vec p = x - (top - Vec{0, size, 0});
  const double beside_axis = std::hypot(p.x, p.z);
  switch (body) {
    case Body::sphere:
      return length(p) - size;
    case Body::plane:
      return p.y - size;
    case Body::capsule:
      return length(p - Vec{std::fmin(size, std::fmax(-size, p.x)), 0, 0}) - size;
    case Body::cylinder:
      return std::fmax(beside_axis, std::abs(p.y)) - size;  // its sign is what counts
    case Body::box:
    case Body::mesh:
      break;
  }
  return std::fmax(std::abs(p.x), std::fmax(std::abs(p.y), std::abs(p.z))) - size;
}

/// 200 places in a square of side 0.7, in a regular pattern that is shifted from row to row.
std::vector<Vec> places() {
  std::vector<Vec> at;
  for (int i = 0; i < 200; ++i) {
    const int row = i / 14, column = i % 14;
    at.push_back({0.05 * column + 0.01 * (row % 3), -0.001 * (row % 5), 0.05 * row});
  }
  return at;
}

weft::ClothId add_level_grid(TestWorld& test, double side, uint32_t n, Vec corner) {
  weft::GridDesc grid;
  grid.rows = grid.columns = n;
  grid.width = grid.height = side;
  grid.material.stiffness = 40;
  grid.material.mass.value = 0.3;
  weft::ClothDesc desc;
  desc.pose = {{1, 0, 0}, 90, to_weft(corner)};
  desc.drag = 1e-4;
  desc.spring_damping = 1e-3;
  return test.add(grid, desc);
}

TEST_P(ManyColliders, TwoHundredOfEachShapeHoldASheet) {
  for (const Body body : every_body) {
    SCOPED_TRACE(name(body));
    weft::WorldDesc desc;
    desc.precision = GetParam();
    TestWorld test(desc);
    const weft::ClothId cloth = add_level_grid(test, 0.6, 50, {0.05, 0.03, 0.05});
    for (const Vec top : places()) add_body(test, body, top, size, 0.5);
    size_t touching = 0;
    for (int frame = 0; frame < 30; ++frame) {
      test.step(1.0 / 60);
      for (const Vec x : test.positions(cloth))
        for (const Vec top : places()) {
          const double d = distance(body, top, x);
          // The cube of triangles is rounded at its edges by its thickness, a tenth of its size.
          ASSERT_GE(d, body == Body::mesh ? -0.06 * size : -1e-6) << frame;
          touching += d < 1e-5;
        }
    }
    EXPECT_GT(touching, 1000u);
  }
}

TEST_P(ManyColliders, ASheetOnAClosedMeshStaysOutside) {
  const double thickness = 0.01;
  const Triangles ball = reference::ball(0.4, 3);
  ASSERT_EQ(ball.faces.size(), 1280u);
  for (const double friction : {0.0, 0.6}) {
    weft::WorldDesc desc;
    desc.precision = GetParam();
    TestWorld test(desc);
    const weft::ClothId cloth = add_level_grid(test, 1, 30, {-0.5, 0.5, -0.5});
    weft::MeshColliderDesc mesh;
    mesh.friction = friction;
    add_collider(test, ball, thickness, true, mesh);
    double nearest = 1e300;
    for (int frame = 1; frame <= 120; ++frame) {
      test.step(1.0 / 60);
      if (frame % 20 != 0) continue;
      for (const Vec x : test.positions(cloth)) {
        nearest = std::fmin(nearest, reference::distance_to_mesh(ball, x));
        ASSERT_FALSE(reference::is_inside(ball, x)) << frame;
      }
    }
    EXPECT_GE(nearest, 0.5 * thickness);
    EXPECT_LE(nearest, 1.0001 * thickness);
  }
}

INSTANTIATE_TEST_SUITE_P(Precision, ManyColliders, both_precisions(), precision_name);

/// One sphere is teleported onto a particle and pushes it into another one, which nothing had a
/// reason to look at before. A particle without springs that makes the list longer changes no bit.
TEST(Culling, LooksAtTheCollidersThatAPushLeadsTo) {
  Vec ends[2];
  for (const bool other : {false, true}) {
    weft::WorldDesc desc;
    desc.gravity = {0, 0, 0};
    TestWorld test(desc);
    NetworkParts parts;
    parts.positions = {{0, 0, 0}, other ? Vec{5.5, 1.001, 0} : Vec{0, 0.1, 0}};
    parts.masses = {1, 1};
    const weft::ClothId id = add_network(test, parts, {});
    weft::SphereDesc sphere;
    sphere.center = {0, 100, 0};
    sphere.radius = 5;
    const weft::ColliderId far = test.take(test.world().create_sphere(sphere));
    sphere.center = {5.5, 0, 0};
    sphere.radius = 1;
    test.take(test.world().create_sphere(sphere));
    test.step(1.0 / 60);
    weft::Pose pose;
    pose.translate = {-0.1, -100, 0};
    test.check(test.world().move_collider(far, pose, weft::Move::teleport));
    test.step(1.0 / 60);
    ends[other] = test.position(id, 0);
  }
  EXPECT_NEAR(ends[0].x, 4.5, 1e-5);
  EXPECT_EQ(ends[0].x, ends[1].x);
}

}  // namespace
}  // namespace weft_tests
