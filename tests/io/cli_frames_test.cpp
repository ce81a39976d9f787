// Frames of `weft run --out` as point caches, and what pictures ask of a run.
#include "io/point_cache.h"

#include "cli_support.h"

namespace weft::io::test {
namespace {

class Frames : public testing::Test {
 protected:
  std::string scene(const Json& json) { return folder.write("scene.json", json.dump()); }
  TemporaryFolder folder;
};

TEST_F(Frames, PointCachesMoveTheMeshOfTheStart) {
  Json json = falling_scene();
  json["cloths"].push_back(network_cloth());
  const std::string to = " --out " + (folder / "f") + " ";
  ASSERT_EQ(run_weft("run --format pc2,obj" + to + scene(json)).code, 0);
  const PointCache sheet = read_point_cache(folder / "f/sheet.pc2");
  const PointCache net = read_point_cache(folder / "f/net.pc2");
  ASSERT_EQ(sheet.points, 12u);
  ASSERT_EQ(net.points, 3u);
  ASSERT_EQ(sheet.samples, 7u);
  EXPECT_EQ(sheet.start, 0);
  EXPECT_EQ(sheet.rate, 1);
  const Mesh rest = read_mesh(folder / "f/sheet.obj");
  const Mesh last = read_mesh(folder / "f/frame_000006.obj");
  ASSERT_EQ(rest.positions.size(), 12u);
  EXPECT_EQ(rest.triangles.size(), 3u * 12);
  for (uint32_t i = 0; i < 12; ++i) {
    EXPECT_EQ(sheet.positions[i].x, float(rest.positions[i].x));
    EXPECT_EQ(sheet.positions[6 * 12 + i].y, float(last.positions[i].y));
  }
  for (uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(net.positions[6 * 3 + i].y, float(last.positions[12 + i].y));
  }
}

TEST_F(Frames, NamesThatNoFileCanHaveAreMadeOnes) {
  Json json = falling_scene();
  json["cloths"][0]["name"] = "../a/b";
  for (int i = 0; i < 2; ++i) {
    json["cloths"].push_back(grid_cloth());
    json["cloths"].back()["name"] = "same";
  }
  ASSERT_EQ(run_weft("run --time 0 --format pc2 --out " + (folder / "f") + " " + scene(json)).code,
            0);
  for (const char* name : {"_._a_b", "same", "same_2"}) {
    EXPECT_EQ(read_point_cache(folder / "f/" + name + ".pc2").points, 12u) << name;
    EXPECT_EQ(read_mesh(folder / "f/" + name + ".obj").positions.size(), 12u) << name;
  }
  EXPECT_EQ(folder.file_count(), 7u) << "and the scene";
}

TEST_F(Frames, ARunThatStopsKeepsThePointsThatItHas) {
  Json json = falling_scene();
  json["solver"] = {{"unsafe", true}};
  json["time"] = {{"duration", 20}, {"frame", 0.5}, {"substeps", 1}};
  json["cloths"][0]["velocities"] = Json::array();
  for (int i = 0; i < 12; ++i) json["cloths"][0]["velocities"].push_back({i % 5, i % 3, i % 7});
  const Outcome outcome = run_weft("run --format pc2 --out " + (folder / "f") + " " + scene(json));
  ASSERT_EQ(outcome.code, 3) << outcome.err;
  const PointCache cache = read_point_cache(folder / "f/sheet.pc2");
  EXPECT_GT(cache.samples, 1u);
  EXPECT_LT(cache.samples, 41u);
}

TEST_F(Frames, ARunThatIsInterruptedKeepsThePointsThatItHas) {
  Json json = falling_scene();
  json["time"] = {{"duration", 1e6}, {"frame", 0.01}};
  const Outcome outcome =
      run_weft("run --every 1 --format pc2 --out " + (folder / "f") + " " + scene(json),
               "exec timeout --preserve-status --signal INT 2 ");
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_CONTAINS(outcome.err, "(signal 2) run it again for the rest");
  EXPECT_GT(read_point_cache(folder / "f/sheet.pc2").samples, 1u);
}

TEST_F(Frames, LargestStretchIsReported) {
  Json json = scene_of(Json::parse(R"({ "name": "pair", "masses": [1, 1], "stiffness": 100,
      "network": { "positions": [[0,0,0],[1,0,0]], "springs": [[0, 1, 100, 0.8]] } })"));
  json["gravity"] = {0, 0, 0};
  json["time"] = {{"duration", 0}};
  const Json report = Json::parse(run_weft("run --json " + scene(json)).out);
  EXPECT_NEAR(report["largest_stretch"], 0.25, 1e-7);
}

TEST_F(Frames, LargestStretchIsThatOfAllFramesNotOfTheLast) {
  // A spring that begins a quarter too long is at its rest length a quarter of its period later.
  Json json = scene_of(Json::parse(R"({ "name": "pair", "masses": [1, 1], "stiffness": 100,
      "network": { "positions": [[0,0,0],[1,0,0]], "springs": [[0, 1, 100, 0.8]] } })"));
  json["gravity"] = {0, 0, 0};
  json["time"] = {{"duration", 0.11}, {"frame", 0.011}};
  const std::string run = "run --json --every 0.011 --out " + (folder / "s") + " ";
  const Json report = Json::parse(run_weft(run + scene(json)).out);
  EXPECT_NEAR(report["largest_stretch"], 0.25, 1e-6);
}

TEST_F(Frames, WithoutOpenGLPicturesAreRefusedAtOnce) {
  const std::string arguments =
      "run --format png --out " + (folder / "f") + " " + scene(falling_scene());
  const Outcome outcome =
      run_weft(arguments, "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null LIBGL_ALWAYS_SOFTWARE=1 exec ");
  expect_failure(outcome, 4, "pictures cannot be made (");
  EXPECT_FALSE(std::filesystem::exists(folder / "f"));
}

}  // namespace
}  // namespace weft::io::test
