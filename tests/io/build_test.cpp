// From scenes to worlds.
#include "io/build.h"

#include "io/scene_size.h"

#include "scene_support.h"

namespace weft::io::test {
namespace {

struct Build : ::testing::Test {
  TemporaryFolder folder;
  Scene read(const Json& json) const { return read_scene(folder.write("s.json", json.dump())); }
};

Json still_scene() {
  Json json = scene_of(grid_cloth());
  json["gravity"] = {0, 0, 0};
  return json;
}

TEST_F(Build, CooksEqualColliderMeshesOnce) {
  folder.write("a.obj", "v 0 -9 0\nv 1 -9 0\nv 0 -9 1\nf 1 2 3\n");
  folder.write("b.obj", "v 0 -9 0\nv 1 -9 0\nv 0 -9 1\nf 1 2 3\n");
  Json json = still_scene();
  json["colliders"] = Json::parse(R"([
    { "mesh": { "file": "a.obj" } },
    { "mesh": { "file": "a.obj", "transform": { "translate": [0,-1,0] } }, "friction": 1 },
    { "mesh": { "file": "a.obj", "transform": { "scale": 2 } } },
    { "sphere": { "center": [0,-9,0], "radius": 1 } },
    { "mesh": { "file": "a.obj", "thickness": 0.01 } },
    { "mesh": { "file": "b.obj" } },
    { "mesh": { "file": "a.obj", "transform": { "scale": 2 } }, "velocity": [0,-1,0] } ])");
  const RunningScene made = build(read(json), {});
  ASSERT_EQ(made.collider_meshes.size(), 4u);
  for (const ColliderMesh& mesh : made.collider_meshes) EXPECT_EQ(mesh.triangle_count(), 1u);
}

TEST_F(Build, NamesTheColliderThatCannotBeCooked) {
  folder.write("a.obj", "v 0 -9 0\nv 1 -9 0\nv 0 -9 1\nf 1 2 3\n");
  Json json = still_scene();
  json["colliders"] = Json::parse(R"([ { "mesh": { "file": "a.obj" } },
                                       { "mesh": { "file": "a.obj", "closed": true } } ])");
  const Scene scene = read(json);
  try {
    build(scene, {});
    ADD_FAILURE() << "an open mesh was taken for a closed one";
  } catch (const CoreError& error) {
    EXPECT_EQ(error.status, Status::invalid_argument);
    EXPECT_CONTAINS(error.what(), "s.json: $.colliders[1]: ");
  }
}

TEST_F(Build, ASpringGivenTwiceIsOneDiagnosticHoweverOften) {
  Json json = still_scene();
  Json springs = Json::array();
  for (int i = 0; i < 1000; ++i) springs.push_back({i % 2, 1 - i % 2});
  json["cloths"][0].erase("grid");
  json["cloths"][0]["network"] = {{"positions", {{0, 0, 0}, {1, 0, 0}}}, {"springs", springs}};
  const RunningScene made = build(read(json), {});
  const View<Diagnostic> diagnostics = made.fabrics[0].diagnostics();
  ASSERT_EQ(diagnostics.count, 1u);
  EXPECT_EQ(diagnostics[0].element, 1u);
  EXPECT_CONTAINS(diagnostics[0].text, "999 springs join two vertices that a spring joins already");
  EXPECT_EQ(made.fabrics[0].spring_count(), 1u);
}

TEST_F(Build, AFileIsReadOnceHoweverItIsSpelt) {
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  Json json = still_scene();
  json["cloths"][0].erase("grid");
  json["cloths"][0]["mesh"] = {{"file", "a.obj"}};
  json["cloths"].push_back(json["cloths"][0]);
  json["cloths"][1]["mesh"]["file"] = "././a.obj";
  const Scene twice = read(json);
  EXPECT_EQ(twice.meshes.size(), 1u);
  EXPECT_EQ(std::get<MeshShape>(twice.cloths[0].shape).mesh,
            std::get<MeshShape>(twice.cloths[1].shape).mesh);
}

TEST_F(Build, RowsThatAreNamedTooOftenAreRefused) {
  Json json = still_scene();
  json["cloths"][0]["grid"]["rows"] = 1;
  json["cloths"][0]["grid"]["columns"] = 100000;
  json["cloths"][0]["pins"] = Json::parse(R"([{"rows": [0, 0]}, {"corners": true}])");
  EXPECT_EQ(read(json).cloths[0].pins.size(), 100000u);
  json["cloths"][0]["pins"] = Json::array({{{"rows", Json(std::vector<int>(1000, 0))}}});
  EXPECT_CONTAINS(input_error([&] { read(json); }),
                  "$.cloths[0].pins[0].rows: pins vertices that were named four times each before");
}

TEST_F(Build, VerticesWithoutATriangleAreADiagnostic) {
  folder.write("a.obj", "v 0 0 0\nv 9 9 9\nv 1 0 0\nv 0 1 0\nv 8 8 8\nf 1 3 4\n");
  Json json = still_scene();
  json["cloths"][0].erase("grid");
  json["cloths"][0]["mesh"] = {{"file", "a.obj"}};
  const RunningScene made = build(read(json), {});
  const View<Diagnostic> diagnostics = made.fabrics[0].diagnostics();
  ASSERT_EQ(diagnostics.count, 1u);
  EXPECT_EQ(diagnostics[0].element, 1u);
  EXPECT_CONTAINS(diagnostics[0].text, "2 vertices belong to no triangle, the first is 1 ");
}

TEST_F(Build, SaysWhatAMachineCannotHoldBeforeItTries) {
  Json json = still_scene();
  json["cloths"][0]["grid"]["rows"] = json["cloths"][0]["grid"]["columns"] = 20000;
  EXPECT_EQ(bytes_to_run(read(json)), uint64_t(400000000) * 250);
  EXPECT_EQ(bytes_to_build(read(json)), 0u) << "a grid's springs are a rule";
  for (int i = 0; i < 9; ++i) json["cloths"].push_back(json["cloths"][0]);
  const Scene many = read(json);
  EXPECT_CONTAINS(input_error([&] { build(many, {}); }),
                  "s.json: $.cloths: a scene of 4000000000 particles (it holds at most 2^30)");
  EXPECT_CONTAINS(beyond_memory(bytes_to_run(many)).value_or(""),
                  "$: takes 1000 GB to run (this machine has ");

  std::string file = "v 0 -9 0\nv 1 -9 0\nv 0 -9 1\n";
  for (int i = 0; i < 1000; ++i) file += "f 1 2 3\n";
  folder.write("a.obj", file);
  json = still_scene();
  const size_t bare = bytes_to_build(read(json));
  json["colliders"] = Json::parse(R"([ { "mesh": { "file": "a.obj" } },
                                       { "mesh": { "file": "a.obj" }, "friction": 1 } ])");
  EXPECT_EQ(bytes_to_build(read(json)), bare + 1000 * 1200 + 50000) << "they share their triangles";
  EXPECT_FALSE(beyond_memory(bytes_to_run(read(json))));
}

TEST_F(Build, PassesWindOn) {
  Json json = still_scene();
  json["wind"] = {{"velocity", {0, 0, 3}}};
  RunningScene made = build(read(json), {});
  ASSERT_EQ(made.world.step(0.05), Status::ok);
  const auto mechanics = made.world.mechanics();
  ASSERT_TRUE(mechanics);
  EXPECT_GT(mechanics->momentum.z, 0.05);
}

TEST_F(Build, PassesSleepOn) {
  Json json = still_scene();
  json["cloths"].push_back(json["cloths"][0]);
  json["cloths"][1]["sleep"] = {{"speed", 0.001}, {"time", 0.05}};
  RunningScene made = build(read(json), {});
  for (int frame = 0; frame < 10; ++frame) ASSERT_EQ(made.world.step(1.0 / 60), Status::ok);
  EXPECT_FALSE(*made.world.asleep(made.cloths[0]));
  EXPECT_TRUE(*made.world.asleep(made.cloths[1]));
}

}  // namespace
}  // namespace weft::io::test
