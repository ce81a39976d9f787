#include "render/sight.h"
#include "render/stage.h"

#include <gtest/gtest.h>

namespace weft::render::test {
namespace {

/// A square metre at z = 0.
io::Surface square() {
  io::Surface surface;
  surface.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  surface.triangles = {{0, 1, 2}, {1, 3, 2}};
  return surface;
}

io::Scene scene_from(double3 eye, double3 target) {
  io::Scene scene;
  scene.cloths.emplace_back();
  scene.camera.eye = eye;
  scene.camera.target = target;
  return scene;
}

std::vector<std::string> problems_of(const io::Scene& scene) {
  const io::Surface surface = square();
  const Framing framing(scene, surface);
  Sight sight(scene, framing);
  sight.add(surface);
  return sight.problems(framing);
}

TEST(Sight, IsContentWithViewsThatShowCloth) {
  EXPECT_TRUE(problems_of(scene_from({0.5, 0.5, 3}, {0.5, 0.5, 0})).empty());
  EXPECT_TRUE(problems_of(scene_from({0.5, 0.5, 0.01}, {0.5, 0.5, 0})).empty())
      << "no corner is in view, but what lies between them";
  io::Scene automatic = scene_from({}, {});
  automatic.camera.eye = automatic.camera.target = std::nullopt;
  EXPECT_TRUE(problems_of(automatic).empty());
}

TEST(Sight, TellsOfViewsFromFarAway) {
  for (const double distance : {1e4, 1e30, 1e150}) {
    const auto far = problems_of(scene_from({0.5, 0.5, distance}, {0.5, 0.5, 0}));
    ASSERT_EQ(far.size(), 1u) << distance;
    EXPECT_NE(far[0].find("less than 2 pixels"), std::string::npos) << far[0];
  }
}

TEST(Sight, TellsOfAnEyeInsideOfACollider) {
  io::Scene scene = scene_from({0.5, 0.5, 3}, {0.5, 0.5, 0});
  SphereDesc sphere;
  sphere.center = {0.5, 0.5, 3.2};
  sphere.radius = 0.5;
  scene.colliders = {PlaneDesc{}, sphere};
  const auto inside = problems_of(scene);
  ASSERT_EQ(inside.size(), 1u);
  EXPECT_EQ(inside[0].find("$.camera.eye: is inside of $.colliders[1]"), 0u) << inside[0];
}

TEST(Sight, TellsOfAnEyeInsideOfAClosedMesh) {
  auto mesh = std::make_shared<io::Mesh>();
  mesh->positions = {{-9, -9, -9}, {9, -9, -9}, {0, 9, -9}, {0, 0, 20}};
  mesh->triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  io::MeshColliderScene collider;
  collider.mesh = mesh;
  io::Scene scene = scene_from({0.5, 0.5, 3}, {0.5, 0.5, 0});
  scene.colliders = {collider};
  EXPECT_TRUE(problems_of(scene).empty()) << "open";
  collider.closed = true;
  scene.colliders = {collider};
  ASSERT_EQ(problems_of(scene).size(), 1u);
  EXPECT_EQ(problems_of(scene)[0].find("$.camera.eye: is inside of $.colliders[0]"), 0u);
}

// A sheet that is near beside another that is far: the first would be cut away.
TEST(Sight, DrawsWhatIsNearAndTellsOfWhatIsTooNear) {
  io::Surface surface = square();
  surface.positions.push_back({0, 0, -300});
  for (const double distance : {2.0, 0.5, 0.1, 0.01}) {
    const io::Scene scene = scene_from({0, 0, distance}, {0, 0, -1});
    const Framing framing(scene, surface);
    Sight sight(scene, framing);
    sight.add(surface);
    const Stage stage = make_stage(scene, framing);
    const Vector3f corner = (Vector3d(0, 0, 0) - stage.origin).cast<float>();
    const Eigen::Vector4f clip =
        stage.camera * Eigen::Vector4f(corner.x(), corner.y(), corner.z(), 1);
    const bool drawn = clip.z() >= -clip.w();
    EXPECT_EQ(drawn, distance > 0.02) << distance;
    EXPECT_EQ(sight.problems(framing).empty(), drawn) << distance;
  }
}

TEST(Sight, TellsOfAWayTooLongForOnePicture) {
  io::Scene scene = scene_from({}, {});
  scene.camera.eye = scene.camera.target = std::nullopt;
  for (const double fall : {10.0, 1e4}) {
    io::Surface surface = square();
    Framing framing(scene, surface);
    Sight sight(scene, framing);
    sight.add(surface);
    for (double3& p : surface.positions) p.y -= fall;
    framing.add(surface);
    sight.add(surface);
    EXPECT_EQ(sight.problems(framing).empty(), fall < 100) << fall;
  }
}

TEST(Sight, AnUprightThatIsNotUpTurnsThePictureAndNotTheView) {
  io::Scene scene = scene_from({}, {});
  scene.camera.eye = scene.camera.target = std::nullopt;
  const io::Surface surface = square();
  const Axes plain = Framing(scene, surface).axes();
  for (const double3 up : {double3{0, -1, 0}, double3{1, 0, 0}, double3{0, 0, 1}}) {
    scene.camera.up = up;
    const Axes axes = Framing(scene, surface).axes();
    EXPECT_LT((axes.back - plain.back).norm(), 1e-12) << "from the same side of the ground";
    EXPECT_GT(axes.up.dot(vector(up)), 0);
  }
}

}  // namespace
}  // namespace weft::render::test
