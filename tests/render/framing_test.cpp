#include "render/framing.h"
#include "render/stage.h"

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
  surface.parts = {{"cloud", 0, surface.positions.size(), 0, 0, 0, 0}};
  return surface;
}

/// Of a scene at rest.
Stage stage_of(io::Scene scene, const io::Surface& surface) {
  scene.gravity = {0, -1e-9, 0};
  return make_stage(scene, surface, make_solids(scene, box_of(surface.positions)));
}

Framing framing_of(const io::Scene& scene, const io::Surface& surface) {
  Framing framing(scene, surface);
  add_cloths(scene, surface, make_solids(scene, box_of(surface.positions)), framing);
  return framing;
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
      const Stage stage = stage_of(scene, surface);
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
      Framing framing(scene, surface);
      for (const double3& p : surface.positions) framing.add(vector(p));
      const Stage stage = stage_of(scene, surface);
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

TEST(Framing, SeesAPointAtRest) {
  const io::Scene scene = plain_scene();
  io::Surface surface;
  surface.positions = {{3, 4, 5}};
  surface.parts = {{"point", 0, 1, 0, 0, 0, 0}};
  const Stage stage = stage_of(scene, surface);
  EXPECT_LT(seen_at(stage, {3, 4, 5}).norm(), 1e-3f);
  EXPECT_GT(stage.radius, 0.5e-3f);
}

TEST(Framing, LooksFromWhereTheSceneSays) {
  io::Scene scene = plain_scene();
  scene.camera.eye = double3{3, 4, 5};
  scene.camera.target = double3{3, 4, 0};
  const Stage stage = stage_of(scene, cloud({3, 4, 0}, {1, 1, 1}));
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

/// With one sphere as a collider, at any time of a second.
Box box_with(const SphereDesc& sphere) {
  io::Scene scene = plain_scene();
  scene.colliders = {sphere};
  const io::Surface surface = cloud({0, 0, 0}, {1, 1, 1});
  Framing framing(scene, surface);
  framing.add(Box{{-1, -1, -1}, {1, 1, 1}});
  add_colliders(make_solids(scene, framing.box()), 1, framing);
  return framing.box();
}

TEST(Framing, TakesInCollidersThatAreNearAndNotThoseFarAway) {
  SphereDesc sphere;
  sphere.center = {1, 0, 0};
  sphere.radius = 1;
  EXPECT_NEAR(box_with(sphere).high.x(), 2, 1e-12);
  sphere.center = {100, 0, 0};
  EXPECT_EQ(box_with(sphere).high, Vector3d(1, 1, 1));
}

TEST(Framing, TakesInCollidersThatPassBy) {
  SphereDesc sphere;
  sphere.center = {-10, 1.4, 0};
  sphere.velocity = {20, 0, 0};
  sphere.radius = 0.2;
  EXPECT_NEAR(box_with(sphere).high.y(), 1.6, 1e-12) << "halfway through a second it is above";
  EXPECT_LT(box_with(sphere).high.x(), 3) << "where it ends is far away";
}

/// A square metre at z = 0.
io::Surface square() {
  io::Surface surface;
  surface.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  surface.triangles = {{0, 1, 2}, {1, 3, 2}};
  surface.parts = {{"square", 0, 4, 0, 2, 0, 0}};
  return surface;
}

TEST(Framing, ExpectsPinnedClothToSwingAndToFlyInTheWind) {
  io::Scene scene = plain_scene();
  scene.cloths[0].pins = {{0, Pin::fixed}, {2, Pin::fixed}};
  const Box hangs = framing_of(scene, square()).box();
  EXPECT_LT((hangs.low - Vector3d(-1, -1, 0)).norm(), 1e-12);
  EXPECT_LT((hangs.high - Vector3d(1, 1, 0)).norm(), 1e-12);
  scene.wind = WindDesc{{0, 0, 3}, 1.2, 1, 0};
  EXPECT_NEAR(framing_of(scene, square()).box().high.z(), 1, 1e-12);
}

TEST(Framing, ExpectsPinsToMove) {
  io::Scene scene = plain_scene();
  scene.gravity = {0, 0, 0};
  scene.time.duration = 3;
  scene.cloths[0].pins = {{0, 0}};
  scene.cloths[0].motions = {{{2, 0, 0}, {0, 0, 0.5}, 1}};
  const Box box = framing_of(scene, square()).box();
  EXPECT_LT((box.low - Vector3d(0, 0, -0.5)).norm(), 1e-12);
  EXPECT_LT((box.high - Vector3d(7, 1, 0.5)).norm(), 1e-12);
}

TEST(Framing, ExpectsFreeClothToFallUntilItLands) {
  io::Scene scene = plain_scene();
  const auto lowest = [&](double duration) {
    scene.time.duration = duration;
    return framing_of(scene, square()).box().low.y();
  };
  EXPECT_NEAR(lowest(0.5), -0.5 * 9.81 * 0.25, 1e-12);
  EXPECT_LT(lowest(100), -5) << "some sizes";
  EXPECT_GT(lowest(100), -8) << "not all of the way, where it would be a dot";
  PlaneDesc ground;
  ground.normal = {0, 1, 0};
  ground.offset = -1;
  scene.colliders = {ground};
  EXPECT_NEAR(lowest(100), -1, 0.3);
  SphereDesc sphere;
  sphere.center = {0.5, -2, 0};
  sphere.radius = 0.5;
  scene.colliders = {sphere};
  EXPECT_LT(lowest(100), -1.75) << "over it";
  EXPECT_GT(lowest(100), -2.5);
  scene.cloths[0].velocity = {0, 0, 2};
  EXPECT_GT(framing_of(scene, square()).box().high.z(), 0.5);
}

// A sheet that is near beside another that is far: the first would be cut away.
TEST(Stage, DrawsWhatIsNear) {
  io::Surface surface = square();
  surface.positions.push_back({0, 0, -300});
  surface.parts[0].vertex_count = 5;
  io::Scene scene = plain_scene();
  for (const double distance : {2.0, 0.5, 0.1}) {
    scene.camera.eye = double3{0, 0, distance};
    scene.camera.target = double3{0, 0, -1};
    const Stage stage = stage_of(scene, surface);
    const Vector3f corner = (-stage.origin).cast<float>();
    const Eigen::Vector4f clip =
        stage.camera * Eigen::Vector4f(corner.x(), corner.y(), corner.z(), 1);
    EXPECT_GE(clip.z(), -clip.w()) << distance;
  }
}

TEST(Framing, AnUprightThatIsNotUpTurnsThePictureAndNotTheView) {
  io::Scene scene = plain_scene();
  const Axes plain = Framing(scene, square()).axes();
  for (const double3 up : {double3{0, -1, 0}, double3{1, 0, 0}, double3{0, 0, 1}}) {
    scene.camera.up = up;
    const Axes axes = Framing(scene, square()).axes();
    EXPECT_LT((axes.back - plain.back).norm(), 1e-12) << "from the same side of the ground";
    EXPECT_GT(axes.up.dot(vector(up)), 0);
  }
}

TEST(Stage, GroundIsThePlaneThatFacesUpOrAFloorBelow) {
  io::Scene scene = plain_scene();
  const io::Surface surface = cloud({0, 5, 0}, {1, 1, 1});
  const Stage floor = stage_of(scene, surface);
  EXPECT_LT(double(floor.ground.y()) + floor.origin.y(), 4.01);
  EXPECT_GT(double(floor.ground.y()) + floor.origin.y(), 3.9);
  PlaneDesc wall, ground;
  wall.normal = {1, 0, 0};
  wall.offset = -3;
  ground.normal = {0, 2, 0};
  ground.offset = 4;  // y = 2
  scene.colliders = {wall, ground};
  const Stage stage = stage_of(scene, surface);
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
  const Stage stage = stage_of(scene, cloud({0, 5, 0}, {1, 1, 1}));
  EXPECT_NEAR(double(stage.ground.y()) + stage.origin.y(), 2, 1e-3);
  EXPECT_EQ(stage.ground_velocity, Vector3f(0, 1.5F, 0));
}

}  // namespace
}  // namespace weft::render::test
