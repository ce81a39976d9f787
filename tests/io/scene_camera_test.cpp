#include "scene_support.h"

namespace weft::io::test {
namespace {

Json scene_with(const char* camera) {
  Json scene = scene_of(grid_cloth());
  scene["camera"] = Json::parse(camera);
  return scene;
}

TEST(SceneCamera, FitsTheSceneUnlessItIsPlaced) {
  const CameraScene camera = read_json(scene_of(grid_cloth())).camera;
  EXPECT_FALSE(camera.eye || camera.target || camera.up);
  EXPECT_EQ(camera.width, 640u);
  EXPECT_EQ(camera.height, 360u);
  EXPECT_EQ(camera.field_of_view, 30);
}

TEST(SceneCamera, ReadsEveryKey) {
  const CameraScene camera = read_json(scene_with(R"({"eye": [1, 2, 3], "target": [0, 0, 1],
      "up": [0, 0, 2], "field_of_view": 45.5, "width": 320.0, "height": 2e2})"))
                                 .camera;
  EXPECT_EQ(camera.eye->y, 2);
  EXPECT_EQ(camera.target->z, 1);
  EXPECT_EQ(camera.up->z, 2);
  EXPECT_EQ(camera.field_of_view, 45.5);
  EXPECT_EQ(camera.width, 320u);
  EXPECT_EQ(camera.height, 200u);
}

TEST(SceneCamera, RefusesWhatShowsNothing) {
  const Json base = scene_with(R"({"eye": [1, 2, 3], "target": [0, 0, 1], "up": [0, 1, 0],
                                   "field_of_view": 30, "width": 64, "height": 64})");
  expect_refused(
      base, {{"/camera/zoom", "1", "$.camera.zoom", "unknown key"},
             {"/camera/eye", "", "$.camera", "has \"target\" alone"},
             {"/camera/target", "", "$.camera", "has \"eye\" alone"},
             {"/camera/target", "[1, 2, 3]", "$.camera.target", "is no direction from \"eye\""},
             {"/camera/eye", "[1, -1e19, 3]", "$.camera.eye[1]", "numbers reach to 1e18"},
             {"/camera/up", "[0, 0, 0]", "$.camera.up", "has no direction"},
             {"/camera/up", "[-0.5, -1, -1]", "$.camera.up", "lies along the view"},
             {"/camera/field_of_view", "0", "$.camera.field_of_view", "0 is out of range"},
             {"/camera/field_of_view", "151", "$.camera.field_of_view", "151 is out of range"},
             {"/camera/field_of_view", "0.009", "$.camera.field_of_view", "0.009 is out of range"},
             {"/camera/width", "64.5", "$.camera.width", "64.5 has the wrong type"},
             {"/camera/width", "1e30", "$.camera.width", "1e+30 is out of range"},
             {"/camera/width", "18446744073709551616", "$.camera.width", "is out of range"},
             {"/camera/width", "15", "$.camera.width", "15 is out of range"},
             {"/camera/height", "8193", "$.camera.height", "8193 is out of range"},
             {"/camera/height", "64.5", "$.camera.height", "64.5 has the wrong type"},
             {"/camera", "[]", "$.camera", "has the wrong type (array) give an object"}});
}

}  // namespace
}  // namespace weft::io::test
