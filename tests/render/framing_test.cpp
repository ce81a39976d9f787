#include "render/framing.h"
#include "render/stage.h"
#include "render/weave.h"

#include <gtest/gtest.h>

#include <random>

namespace weft::render::test {
namespace {

io::Scene plain_scene() {
  io::Scene scene;
  scene.cloths.emplace_back();
  return scene;
}

io::Surface cloud(Vector3d middle, Vector3d half) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  io::Surface surface;
  for (int i = 0; i < 500; ++i) {
    const double x = unit(random), y = unit(random), z = unit(random);
    surface.positions.push_back(
        {middle.x() + x * half.x(), middle.y() + y * half.y(), middle.z() + z * half.z()});
  }
  return surface;
}

/// Where a world point is in the picture, -1 to 1.
Eigen::Vector2f seen_at(const Stage& stage, double3 p) {
  const Vector3f local = (vector(p) - stage.origin).cast<float>();
  const Eigen::Vector4f clip = stage.camera * Eigen::Vector4f(local.x(), local.y(), local.z(), 1);
  EXPECT_GT(clip.w(), 0);
  EXPECT_LE(std::abs(clip.z()), clip.w()) << "between near and far";
  return {clip.x() / clip.w(), clip.y() / clip.w()};
}

TEST(Framing, HasEverythingInThePictureAndNoRoomToSpare) {
  for (const Vector3d& half : {Vector3d(1, 1, 1), Vector3d(5, 0.1, 0.1), Vector3d(0.1, 5, 0.1)}) {
    for (const double far : {0.0, 1e6}) {
      const io::Scene scene = plain_scene();
      const io::Surface surface = cloud({far, far, -far}, half);
      const Stage stage = make_stage(scene, Framing(scene, surface));
      Eigen::Vector2f least(9, 9), most(-9, -9);
      for (const double3& p : surface.positions) {
        least = least.cwiseMin(seen_at(stage, p));
        most = most.cwiseMax(seen_at(stage, p));
      }
      EXPECT_GE(least.minCoeff(), -1);
      EXPECT_LE(most.maxCoeff(), 1);
      EXPECT_GT((most - least).maxCoeff(), 2 * 0.85);
    }
  }
}

// From the nearest place at which all is in view, a wide lens would stand in the cloth.
TEST(Framing, KeepsItsDistanceAlsoWithWideLenses) {
  for (const Vector3d& half : {Vector3d(1, 0, 1), Vector3d(0.5, 0.5, 0.5), Vector3d(0.1, 0, 5)}) {
    for (const double angle : {20.0, 60.0, 90.0, 120.0, 150.0}) {
      io::Scene scene = plain_scene();
      scene.camera.field_of_view = angle;
      const io::Surface surface = cloud({3, 0.6, 0}, half);
      const Framing framing(scene, surface);
      const Stage stage = make_stage(scene, framing);
      double nearest = 1e300;
      for (const double3& p : surface.positions) {
        const Eigen::Vector2f at = seen_at(stage, p);
        EXPECT_LE(at.cwiseAbs().maxCoeff(), 1);
        nearest = std::min(nearest, framing.axes().back.dot(framing.eye() - vector(p)));
      }
      EXPECT_GE(nearest, 0.3 * framing.box().radius()) << angle;
    }
  }
}

// Vertices of a mesh that no triangle has are not drawn, wherever they fall.
TEST(Framing, LeavesOutLooseVertices) {
  io::Scene scene = plain_scene();
  scene.cloths[0].shape = io::MeshShape{};
  io::Surface surface;
  surface.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -100, 0}};
  surface.triangles = {{0, 1, 2}};
  surface.parts = {{"m", 0, 4, 0, 1, 0, 0}};
  EXPECT_EQ(Framing(scene, surface).box().low.y(), 0);
  EXPECT_TRUE(bars(scene, surface).empty());
  scene.cloths[0].shape = io::NetworkShape{};
  EXPECT_EQ(Framing(scene, surface).box().low.y(), -100);
  EXPECT_EQ(bars(scene, surface).size(), 1u);
}

TEST(Framing, SeesAPointAtRest) {
  const io::Scene scene = plain_scene();
  io::Surface surface;
  surface.positions = {{3, 4, 5}};
  const Stage stage = make_stage(scene, Framing(scene, surface));
  EXPECT_LT(seen_at(stage, {3, 4, 5}).norm(), 1e-3f);
  EXPECT_GT(stage.radius, 0.5e-3f);
}

TEST(Framing, LooksFromWhereTheSceneSays) {
  io::Scene scene = plain_scene();
  scene.camera.eye = double3{3, 4, 5};
  scene.camera.target = double3{3, 4, 0};
  const Stage stage = make_stage(scene, Framing(scene, cloud({3, 4, 0}, {1, 1, 1})));
  EXPECT_LT(seen_at(stage, {3, 4, 0}).norm(), 1e-5f);
  EXPECT_GT(seen_at(stage, {3, 4.5, 0}).y(), 0);
  EXPECT_GT(seen_at(stage, {3.5, 4, 0}).x(), 0);
}

TEST(Framing, LooksAtTheWideSideOfAnUprightCloth) {
  const io::Scene scene = plain_scene();
  io::Surface surface = cloud({0, 0, 0}, {0.001, 1, 1});
  surface.normals.assign(surface.positions.size(), {1, 0, 0});
  const Framing framing(scene, surface);
  EXPECT_GT(std::abs(framing.axes().back.x()), std::abs(framing.axes().back.z()));
}

TEST(Framing, TakesInCollidersThatAreNearAndNotThoseFarAway) {
  io::Scene scene = plain_scene();
  const Framing alone(scene, cloud({0, 0, 0}, {1, 1, 1}));
  SphereDesc sphere;
  sphere.center = {1, 0, 0};
  sphere.radius = 1;
  scene.colliders = {sphere};
  Framing with = alone;
  add_colliders(scene, with);
  EXPECT_NEAR(with.box().high.x(), 2, 1e-12);
  sphere.center = {100, 0, 0};
  scene.colliders = {sphere};
  Framing without = alone;
  add_colliders(scene, without);
  EXPECT_EQ(without.box().high, alone.box().high);
}

TEST(Stage, GroundIsThePlaneThatFacesUpOrAFloorBelow) {
  io::Scene scene = plain_scene();
  const Framing framing(scene, cloud({0, 5, 0}, {1, 1, 1}));
  const Stage floor = make_stage(scene, framing);
  EXPECT_LT(double(floor.ground.y()) + floor.origin.y(), 4.01);
  EXPECT_GT(double(floor.ground.y()) + floor.origin.y(), 3.9);
  PlaneDesc wall, ground;
  wall.normal = {1, 0, 0};
  wall.offset = -3;
  ground.normal = {0, 2, 0};
  ground.offset = 4;  // y = 2
  scene.colliders = {wall, ground};
  const Stage stage = make_stage(scene, framing);
  EXPECT_NEAR(double(stage.ground.y()) + stage.origin.y(), 2, 1e-3);
  EXPECT_EQ(stage.ground_normal, Vector3f(0, 1, 0));
  EXPECT_EQ(stage.ground_velocity, Vector3f(0, 0, 0));
}

TEST(Stage, AGroundThatMovesIsStillTheGround) {
  io::Scene scene = plain_scene();
  PlaneDesc ground;
  ground.normal = {0, 2, 0};
  ground.offset = 4;
  ground.velocity = {3, 1.5, 0};
  scene.colliders = {ground};
  const Stage stage = make_stage(scene, Framing(scene, cloud({0, 5, 0}, {1, 1, 1})));
  EXPECT_NEAR(double(stage.ground.y()) + stage.origin.y(), 2, 1e-3);
  EXPECT_EQ(stage.ground_velocity, Vector3f(0, 1.5F, 0));
}

TEST(Framing, TakesInCollidersThatPassBy) {
  io::Scene scene = plain_scene();
  Framing framing(scene, cloud({0, 0, 0}, {1, 1, 1}));
  SphereDesc sphere;
  sphere.center = {-10, 1.4, 0};
  sphere.velocity = {20, 0, 0};
  sphere.radius = 0.2;
  scene.colliders = {sphere};
  add_colliders(scene, framing);
  EXPECT_NEAR(framing.box().high.y(), 1.6, 1e-12) << "halfway through a second it is above";
  EXPECT_LT(framing.box().high.x(), 3) << "where it ends is far away";
}

}  // namespace
}  // namespace weft::render::test
