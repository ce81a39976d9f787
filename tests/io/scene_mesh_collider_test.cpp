// Colliders made of triangles.
#include "scene_support.h"

namespace weft::io::test {
namespace {

struct SceneMeshCollider : ::testing::Test {
  SceneMeshCollider() {
    folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("cloud.obj", "v 0 0 0\n");
    folder.write("broken.obj", "v 0 0 0\nv x\n");
  }
  Scene read(const Json& json) const { return read_scene(folder.write("s.json", json.dump())); }
  std::string error(const char* pointer, const Json& value) const {
    Json json = scene_with(R"([{"mesh": {"file": "m.obj"}}])");
    read(json);
    json[Json::json_pointer(pointer)] = value;
    return input_error([&] { read(json); });
  }
  static Json scene_with(const char* colliders) {
    Json json = scene_of(grid_cloth());
    json["colliders"] = Json::parse(colliders);
    return json;
  }
  TemporaryFolder folder;
};

TEST_F(SceneMeshCollider, NeedsAFileOnly) {
  const Scene scene = read(scene_with(R"([{"mesh": {"file": "m.obj"}}])"));
  const auto& mesh = std::get<MeshColliderScene>(scene.colliders.at(0));
  EXPECT_EQ(mesh.mesh->triangles.size(), 3u);
  EXPECT_EQ(mesh.scale, 1);
  EXPECT_EQ(mesh.thickness, 0.005);
  EXPECT_FALSE(mesh.closed);
  EXPECT_EQ(mesh.pose.degrees, 0);
  EXPECT_EQ(mesh.pose.translate.y, 0);
  EXPECT_EQ(mesh.friction, 0);
  EXPECT_EQ(mesh.velocity.x, 0);
}

TEST_F(SceneMeshCollider, ReadsEveryKey) {
  const Scene scene = read(scene_with(R"([{ "friction": 0.25, "velocity": [0,0,3],
    "mesh": { "file": "m.obj", "thickness": 0.01, "closed": true,
              "transform": { "scale": 2, "rotate": { "axis": [0,0,1], "degrees": 30 },
                             "translate": [1,2,3] } } }])"));
  const auto& mesh = std::get<MeshColliderScene>(scene.colliders.at(0));
  EXPECT_EQ(mesh.scale, 2);
  EXPECT_EQ(mesh.pose.axis.z, 1);
  EXPECT_EQ(mesh.pose.degrees, 30);
  EXPECT_EQ(mesh.pose.translate.z, 3);
  EXPECT_EQ(mesh.thickness, 0.01);
  EXPECT_TRUE(mesh.closed);
  EXPECT_EQ(mesh.friction, 0.25);
  EXPECT_EQ(mesh.velocity.z, 3);
}

TEST_F(SceneMeshCollider, SharesItsFileWithCloths) {
  Json json = scene_with(R"([{"mesh": {"file": "m.obj"}}, {"mesh": {"file": "m.obj"}}])");
  json["cloths"].push_back(
      {{"name", "m"}, {"mass", 1}, {"stiffness", 1}, {"mesh", {{"file", "m.obj"}}}});
  const Scene scene = read(json);
  const auto& cloth = std::get<MeshShape>(scene.cloths.at(1).shape);
  for (const ColliderScene& collider : scene.colliders) {
    EXPECT_EQ(std::get<MeshColliderScene>(collider).mesh, cloth.mesh) << "read once";
  }
}

TEST_F(SceneMeshCollider, RefusesBadValues) {
  const auto expect = [&](const char* pointer, const Json& value, const std::string& message) {
    EXPECT_CONTAINS(error(pointer, value), "s.json: $.colliders[0]" + message);
  };
  expect("/colliders/0/mesh", Json::object(), ".mesh.file: is missing");
  expect("/colliders/0/mesh", "m.obj", ".mesh: \"m.obj\" has the wrong type");
  expect("/colliders/0/mesh/file", "", ".mesh.file: \"\" names no file");
  expect("/colliders/0/mesh/file", 3, ".mesh.file: 3 has the wrong type");
  expect("/colliders/0/mesh/bend", true, ".mesh.bend: unknown key");
  expect("/colliders/0/mesh/thickness", 0, ".mesh.thickness: 0 is out of range");
  expect("/colliders/0/mesh/thickness", -1, ".mesh.thickness: -1 is out of range");
  expect("/colliders/0/mesh/closed", 1, ".mesh.closed: 1 has the wrong type");
  expect("/colliders/0/mesh/transform", Json::array(), ".mesh.transform: an array of 0");
  expect("/colliders/0/mesh/transform/scale", 0, ".mesh.transform.scale: 0 is out of range");
  expect("/colliders/0/mesh/transform/rotate", Json::parse(R"({"axis": [0,0,0], "degrees": 5})"),
         ".mesh.transform.rotate.axis: [0, 0, 0] has no direction");
  expect("/colliders/0/mesh/transform/translate", 1,
         ".mesh.transform.translate: 1 has the wrong type");
  expect("/colliders/0/mesh/transform/move", 1, ".mesh.transform.move: unknown key");
  expect("/colliders/0/friction", -1, ".friction: -1 is out of range");
  expect("/colliders/0/velocity", 1, ".velocity: 1 has the wrong type");
  expect("/colliders/0/box", Json::object(), ": has box and mesh");
}

TEST_F(SceneMeshCollider, RefusesBadFiles) {
  const auto file_error = [&](const char* name) { return error("/colliders/0/mesh/file", name); };
  EXPECT_CONTAINS(file_error("no.obj"), "s.json: $.colliders[0].mesh.file: ");
  EXPECT_CONTAINS(file_error("no.obj"), "no.obj: cannot be read");
  EXPECT_CONTAINS(file_error("broken.obj"), "broken.obj: line 2: vertex 2: x 'x'");
  EXPECT_CONTAINS(file_error("cloud.obj"),
                  "cloud.obj: has no faces (cloth collides with them) give a surface");
}

}  // namespace
}  // namespace weft::io::test
