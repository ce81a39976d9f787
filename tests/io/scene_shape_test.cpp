// "grid", "mesh" and "network".
#include "scene_support.h"

namespace weft::io::test {
namespace {

TEST(SceneShape, ReadsAGrid) {
  const auto cloth = read_cloth_json(grid_cloth());
  const auto& grid = std::get<GridShape>(cloth.shape);
  EXPECT_EQ(grid.rows, 3u);
  EXPECT_EQ(grid.columns, 4u);
  EXPECT_EQ(grid.height, 2);
  EXPECT_EQ(grid.stencil, Stencil::seed12);
  EXPECT_EQ(vertex_count(cloth.shape), 12u);
}

TEST(SceneShape, RefusesBadGrids) {
  const std::string grid = "$.cloths[0].grid";
  expect_refused(
      scene_of(grid_cloth()),
      {{"/cloths/0/grid", "[]", "$.cloths[0].grid", "wrong type"},
       {"/cloths/0/grid/rows", "0", "$.cloths[0].grid.rows",
        "0 is out of range (a grid has 1 to 2^30 vertices) give an integer >= 1"},
       {"/cloths/0/grid/rows", "", "$.cloths[0].grid.rows", "is missing"},
       {"/cloths/0/grid/rows", "2.5", "$.cloths[0].grid.rows", "2.5 has the wrong type"},
       {"/cloths/0/grid/rows", "1000000000", "$.cloths[0].grid.columns", "more than 2^30"},
       {"/cloths/0/grid/columns", "-1", "$.cloths[0].grid.columns", "-1 is out of range"},
       {"/cloths/0/grid/width", "0", "$.cloths[0].grid.width", "0 is out of range"},
       {"/cloths/0/grid/height", "", "$.cloths[0].grid.height", "is missing"},
       {"/cloths/0/grid/stencil", "\"hex\"", "$.cloths[0].grid.stencil", "\"hex\""},
       {"/cloths/0/grid/cols", "4", "$.cloths[0].grid.cols", "unknown key"}});
}

TEST(SceneShape, NeedsExactlyOneShape) {
  Json cloth = grid_cloth();
  cloth["network"] = network_cloth()["network"];
  EXPECT_CONTAINS(input_error([&] { read_cloth_json(cloth); }),
                  "$.cloths[0]: has grid and network (exactly one is allowed)");
  cloth.erase("network");
  cloth.erase("grid");
  EXPECT_CONTAINS(input_error([&] { read_cloth_json(cloth); }), "none of grid, mesh, network");
}

TEST(SceneShape, ReadsANetwork) {
  const auto cloth = read_cloth_json(network_cloth());
  const auto& network = std::get<NetworkShape>(cloth.shape);
  EXPECT_EQ(network.positions[2].y, 1);
  ASSERT_EQ(network.springs.size(), 3u);
  EXPECT_EQ(network.springs[0].stiffness, -1);
  EXPECT_EQ(network.springs[1].stiffness, 50);
  EXPECT_EQ(network.springs[1].rest_length, -1);
  EXPECT_EQ(network.springs[2].rest_length, 1.5);
}

TEST(SceneShape, RefusesBadNetworks) {
  expect_refused(
      scene_of(network_cloth()),
      {{"/cloths/0/network/positions", "", "$.cloths[0].network.positions", "is missing"},
       {"/cloths/0/network/positions", "[]", "$.cloths[0].network.positions", "is empty"},
       {"/cloths/0/network/positions/1", "[1,2]", "$.cloths[0].network.positions[1]", "of 2"},
       {"/cloths/0/network/springs", "", "$.cloths[0].network.springs", "is missing"},
       {"/cloths/0/network/springs/0", "[0]", "$.cloths[0].network.springs[0]", "not a spring"},
       {"/cloths/0/network/springs/0", "[0,1,2,3,4]", "$.cloths[0].network.springs[0]", "of 5"},
       {"/cloths/0/network/springs/1", "[0,3]", "$.cloths[0].network.springs[1][1]",
        "3 is out of range (there are 3 vertices)"},
       {"/cloths/0/network/springs/1", "[-1,2]", "$.cloths[0].network.springs[1][0]", "-1 is out"},
       {"/cloths/0/network/springs/1", "[1,1]", "$.cloths[0].network.springs[1]", "to itself"},
       {"/cloths/0/network/springs/1", "[0,1,-5]", "$.cloths[0].network.springs[1][2]", "-5 is"},
       {"/cloths/0/network/springs/1", "[0,1,5,-1]", "$.cloths[0].network.springs[1][3]", "-1 is"},
       {"/cloths/0/network/edges", "[]", "$.cloths[0].network.edges", "unknown key"}});
}

TEST(SceneShape, ReadsAMeshBesideTheScene) {
  const TemporaryFolder folder;
  folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  Json cloth{{"name", "m"}, {"mass", 1}, {"stiffness", 1}, {"mesh", {{"file", "m.obj"}}}};
  Json scene = scene_of(cloth);
  scene["cloths"].push_back(cloth);
  const Scene read = read_scene(folder.write("s.json", scene.dump()));
  const auto& mesh = std::get<MeshShape>(read.cloths[0].shape);
  EXPECT_EQ(mesh.mesh->triangles.size(), 3u);
  EXPECT_FALSE(mesh.bend);
  EXPECT_EQ(mesh.mesh, std::get<MeshShape>(read.cloths[1].shape).mesh) << "read once";
}

TEST(SceneShape, RefusesBadMeshes) {
  const TemporaryFolder folder;
  folder.write("cloud.obj", "v 0 0 0\n");
  folder.write("broken.obj", "v 0 0 0\nv x\n");
  const auto error = [&](const Json& mesh) {
    const Json cloth{{"name", "m"}, {"mass", 1}, {"stiffness", 1}, {"mesh", mesh}};
    return input_error([&] { read_scene(folder.write("s.json", scene_of(cloth).dump())); });
  };
  EXPECT_CONTAINS(error({{"file", "no.obj"}}), "s.json: $.cloths[0].mesh.file: ");
  EXPECT_CONTAINS(error({{"file", "no.obj"}}), "no.obj: cannot be read");
  EXPECT_CONTAINS(error({{"file", "broken.obj"}}), "broken.obj: line 2: vertex 2: x 'x'");
  EXPECT_CONTAINS(error({{"file", "cloud.obj"}}), "cloud.obj: has no faces");
  EXPECT_CONTAINS(error({{"file", ""}}), "names no file");
  for (const std::string& odd : {std::string(1001, 'a'), std::string("a\nb.obj")}) {
    EXPECT_CONTAINS(error({{"file", odd}}), "is no path that is read (it has control characters");
    EXPECT_LT(error({{"file", odd}}).size(), 300u);
  }
  EXPECT_CONTAINS(error({{"file", 3}}), "3 has the wrong type");
  EXPECT_CONTAINS(error({{"bend", true}}), "$.cloths[0].mesh.file: is missing");
  EXPECT_CONTAINS(error({{"file", "cloud.obj"}, {"bend", 1}}), "$.cloths[0].mesh.bend: 1");
}

TEST(SceneShape, RefusesBadFiles) {
  const TemporaryFolder folder;
  EXPECT_CONTAINS(input_error([&] { read_scene(folder / "no.json"); }), "cannot be read");
  EXPECT_CONTAINS(input_error([&] { read_scene(folder.string()); }), "is a directory");
  EXPECT_CONTAINS(input_error([&] { read_scene(folder.write("e.json", "")); }), "is empty");
}

}  // namespace
}  // namespace weft::io::test
