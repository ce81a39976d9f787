// What is drawn of a collider lies below the triangles of the cloths on it, compared with dense
// sampling.
#include "render/reach.h"
#include "render/solids.h"

#include "io/build.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace weft::render::test {
namespace {

template <class Use>
void each_sample(const std::array<Vector3d, 3>& t, int steps, Use use) {
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const double u = double(i) / steps, v = double(j) / steps;
      use(Vector3d(u * t[0] + v * t[1] + (1 - u - v) * t[2]));
    }
  }
}

std::vector<io::ColliderScene> one_of_each() {
  SphereDesc sphere;
  sphere.center = {0.1, 0, 0};
  sphere.radius = 0.4;
  CapsuleDesc capsule;
  capsule.a = {-0.5, 0, 0.1};
  capsule.b = {0.4, 0.1, 0};
  capsule.radius = 0.3;
  CylinderDesc cylinder;
  cylinder.a = {0, -0.4, 0};
  cylinder.b = {0.1, 0.4, 0};
  cylinder.radius = 0.35;
  BoxDesc box;
  box.half = {0.4, 0.3, 0.5};
  box.axis = {1, 2, 0};
  box.degrees = 35;
  return {sphere, capsule, cylinder, box};
}

// By other formulas than the depth: samples of the axis, a cross product, a turn back.
bool contains(const io::ColliderScene& collider, const Vector3d& p) {
  if (const auto* d = std::get_if<SphereDesc>(&collider)) {
    return (p - vector(d->center)).norm() <= d->radius;
  }
  if (const auto* d = std::get_if<CapsuleDesc>(&collider)) {
    for (int i = 0; i <= 2000; ++i) {
      const Vector3d on = vector(d->a) + (vector(d->b) - vector(d->a)) * (i / 2000.0);
      if ((p - on).norm() <= d->radius) return true;
    }
    return false;
  }
  if (const auto* d = std::get_if<CylinderDesc>(&collider)) {
    const Vector3d axis = vector(d->b) - vector(d->a), from = p - vector(d->a);
    const double t = from.dot(axis) / axis.dot(axis);
    return t >= 0 && t <= 1 && from.cross(axis).norm() / axis.norm() <= d->radius;
  }
  const auto& d = std::get<BoxDesc>(collider);
  const Vector3d q = Eigen::AngleAxisd(-d.degrees * M_PI / 180, vector(d.axis).normalized()) *
                     (p - vector(d.center));
  return (q.cwiseAbs().array() <= vector(d.half).array()).all();
}

TEST(Reach, DepthIsPositiveInsideAndItsSlopeIsItsGradient) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-0.8, 0.8);
  for (const io::ColliderScene& collider : one_of_each()) {
    size_t inside = 0, smooth = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vector3d p(unit(random), unit(random), unit(random));
      const Depth depth = *depth_in(collider, 0, p);
      const bool clear = std::abs(depth.value) > 1e-3;
      EXPECT_TRUE(!clear || (depth.value > 0) == contains(collider, p)) << p;
      inside += depth.value > 0;
      EXPECT_LE(depth.slope.norm(), 1 + 1e-12);
      const Vector3d step = 1e-6 * Vector3d(unit(random), unit(random), unit(random));
      const double after = depth_in(collider, 0, p + step)->value;
      EXPECT_LE(after, depth.value + depth.slope.dot(step) + 1e-12) << "concave";
      smooth += std::abs(after - depth.value - depth.slope.dot(step)) < 1e-10;
    }
    EXPECT_GT(inside, 50u);
    EXPECT_GT(smooth, 1990u);
  }
}

TEST(Reach, MovesWithItsCollider) {
  SphereDesc sphere;
  sphere.radius = 1;
  sphere.velocity = {2, 0, 0};
  EXPECT_NEAR(depth_in(sphere, 3, {6, 0.25, 0})->value, 0.75, 1e-15);
  EXPECT_FALSE(depth_in(PlaneDesc{}, 0, {0, 0, 0}));
  EXPECT_FALSE(depth_in(io::MeshColliderScene{}, 0, {0, 0, 0}));
}

TEST(Reach, IsWhatDenseSamplingFinds) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-0.9, 0.9);
  io::Scene scene;
  scene.cloths.emplace_back();
  scene.colliders = one_of_each();
  for (int round = 0; round < 60; ++round) {
    io::Surface surface;
    for (int i = 0; i < 3; ++i) {
      surface.positions.push_back({unit(random), unit(random), unit(random)});
    }
    surface.triangles = {{0, 1, 2}};
    Reach reach(scene, surface);
    reach.add(surface, 0);
    const std::array<Vector3d, 3> corners{
        vector(surface.positions[0]), vector(surface.positions[1]), vector(surface.positions[2])};
    for (size_t c = 0; c < scene.colliders.size(); ++c) {
      double most = -9, own = 0;
      for (const Vector3d& p : corners) {
        own = std::max(own, depth_in(scene.colliders[c], 0, p)->value);
      }
      each_sample(corners, 150, [&](const Vector3d& p) {
        most = std::max(most, depth_in(scene.colliders[c], 0, p)->value);
      });
      const double want = std::max(0.0, most - own);
      EXPECT_GE(reach.depths()[c], want - 1e-12);
      const double edge =
          std::max((corners[1] - corners[0]).norm(), (corners[2] - corners[0]).norm());
      EXPECT_LE(reach.depths()[c], want + edge / 50 + edge / 150) << "samples are no closer";
    }
  }
}

/// Every fourth frame of a scene.
std::vector<io::Surface> fallen(const io::Scene& scene) {
  io::Simulation made = io::build(scene, {});
  io::Surface surface = io::make_surface(scene, made);
  std::vector<io::Surface> moments;
  for (int frame = 0; frame < 48; ++frame) {
    EXPECT_EQ(made.world.step(scene.time.frame), Status::ok);
    if (frame % 4 != 3) continue;
    EXPECT_EQ(made.world.read_positions(made.cloths[0], surface.positions.data()), Status::ok);
    moments.push_back(surface);
  }
  return moments;
}

io::Scene sheet_on(const std::string& collider, int side) {
  const std::string n = std::to_string(side);
  return io::read_scene_text(
      R"({"weft": 1, "cloths": [{"name": "sheet", "mass": 1,
          "grid": {"rows": )" +
          n + R"(, "columns": )" + n + R"(, "width": 1, "height": 1, "stencil": "seed12"},
          "transform": {"rotate": {"axis": [1, 0, 0], "degrees": 90},
                        "translate": [-0.5, 0.35, -0.5]},
          "stiffness": {"stretch": 30, "shear": 10, "bend": 0.5}, "damping": {"drag": 2e-5}}],
          "colliders": [)" +
          collider + "]}",
      "s.json");
}

// Sheets so coarse that their triangles cut deep into what their particles lie on.
TEST(Reach, CoarseSheetsHideNothingOfTheirCollider) {
  const char* const colliders[] = {
      R"({"sphere": {"center": [0, 0, 0], "radius": 0.3}, "friction": 0.3})",
      R"({"capsule": {"a": [-0.2, 0, 0], "b": [0.2, 0, 0], "radius": 0.25}, "friction": 0.3})",
      R"({"cylinder": {"a": [0, -0.4, 0], "b": [0, 0.3, 0], "radius": 0.3}, "friction": 0.3})",
      R"({"box": {"center": [0, 0, 0], "half": [0.3, 0.25, 0.2],
                  "rotate": {"axis": [0, 1, 0], "degrees": 30}}, "friction": 0.3})"};
  for (const char* collider : colliders) {
    for (const int side : {8, 16, 32, 64}) {
      const io::Scene scene = sheet_on(collider, side);
      const std::vector<io::Surface> moments = fallen(scene);
      Reach reach(scene, moments[0]);
      double lowest = 0, highest = 0;
      for (const io::Surface& moment : moments) reach.add(moment, 0);
      for (const io::Surface& moment : moments) {
        for (const auto& t : moment.triangles) {
          const std::array<Vector3d, 3> corners{vector(moment.positions[t[0]]),
                                                vector(moment.positions[t[1]]),
                                                vector(moment.positions[t[2]])};
          for (const Vector3d& p : corners) {
            lowest = std::max(lowest, depth_in(scene.colliders[0], 0, p)->value);
          }
          each_sample(corners, 6, [&](const Vector3d& p) {
            highest = std::max(highest, depth_in(scene.colliders[0], 0, p)->value);
          });
        }
      }
      EXPECT_LT(lowest, 1e-6) << "no particle is inside";
      EXPECT_GE(reach.depths()[0] + 1e-6, highest) << collider << side;
      EXPECT_LT(reach.depths()[0], 0.12) << "the picture still shows the collider " << side;
      EXPECT_GT(highest, side <= 16 ? 1e-3 : 0) << "there was something to find";
    }
  }
}

}  // namespace
}  // namespace weft::render::test
