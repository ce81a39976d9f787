// What a run writes.
#include "cli_support.h"

#include "io/mesh.h"

#include <cmath>
#include <sstream>

namespace weft::io::test {
namespace {

struct Run : ::testing::Test {
  TemporaryFolder folder;
  std::string scene(const Json& json) const { return folder.write("s.json", json.dump()); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder / name); }
};

TEST_F(Run, ReportsOnStandardOutput) {
  const Outcome outcome = run_weft("run --json " + scene(falling_scene()));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["particles"], 12);
  EXPECT_EQ(report["frames"], 6);
  EXPECT_EQ(report["steps"], 6 * report["substeps_per_frame"].get<int>());
  EXPECT_EQ(report["precision"], "float64");
  EXPECT_EQ(report["evaluation"], "gather");
  EXPECT_EQ(report["state_hash"].get<std::string>().size(), 16u);
  EXPECT_EQ(folder.file_count(), 1u) << "nothing but the scene";
  EXPECT_CONTAINS(run_weft("run " + scene(falling_scene())).out, "particles  12\n");
}

TEST_F(Run, WritesFinalStateAndReport) {
  const Outcome outcome = run_weft("run --final " + (folder / "f.csv") + " --report " +
                                   (folder / "r.json") + " " + scene(falling_scene()));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream csv(read_text(folder / "f.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "cloth,vertex,x,y,z,vx,vy,vz");
  std::getline(csv, line);
  int cloth, vertex;
  double x[3], v[3];
  ASSERT_EQ(std::sscanf(line.c_str(), "%d,%d,%lf,%lf,%lf,%lf,%lf,%lf", &cloth, &vertex, x, x + 1,
                        x + 2, v, v + 1, v + 2),
            8);
  EXPECT_EQ(cloth, 0);
  EXPECT_EQ(vertex, 0);
  EXPECT_NEAR(x[1], -9.81 * 0.1 * 0.1 / 2, 1e-12) << "free fall is exact";
  EXPECT_NEAR(v[1], -0.981, 1e-10);
  EXPECT_EQ(Json::parse(read_text(folder / "r.json"))["frames"], 6);
  EXPECT_EQ(folder.file_count(), 3u) << "no temporary file stays";
}

TEST_F(Run, TimeOverridesDuration) {
  const std::string file = scene(falling_scene());
  EXPECT_EQ(Json::parse(run_weft("run --json --time 0.05 " + file).out)["frames"], 3);
  const Json still = Json::parse(run_weft("run --json --time 0 " + file).out);
  EXPECT_EQ(still["frames"], 0);
  EXPECT_EQ(still["steps"], 0);
  EXPECT_GE(still["substeps_per_frame"], 1);
  EXPECT_TRUE(still["ns_per_particle_step"].is_null());
}

TEST_F(Run, WritesEveryFrameOfEveryFormat) {
  Json json = falling_scene();
  json["cloths"].push_back(network_cloth());
  const Outcome outcome =
      run_weft("run --out " + (folder / "deep/frames") + " --format obj,ply " + scene(json));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(folder.file_count(), 1u + 2 * 7);
  const Mesh obj = read_mesh(folder / "deep/frames/frame_000006.obj");
  const Mesh ply = read_mesh(folder / "deep/frames/frame_000006.ply");
  ASSERT_EQ(obj.positions.size(), 15u);
  EXPECT_EQ(obj.triangles.size(), 3u * 12);
  EXPECT_EQ(obj.triangles, ply.triangles);
  for (size_t i = 0; i < 15; ++i) {
    EXPECT_EQ(obj.positions[i].y, ply.positions[i].y);
  }
  EXPECT_EQ(read_mesh(folder / "deep/frames/frame_000000.obj").positions[0].y, 0) << "the start";
}

TEST_F(Run, WritesAFrameEverySoManySeconds) {
  const std::string arguments = " --out " + (folder / "f") + " " + scene(falling_scene());
  ASSERT_EQ(run_weft("run --every 0.05" + arguments).code, 0);
  EXPECT_TRUE(exists("f/frame_000002.obj"));
  EXPECT_FALSE(exists("f/frame_000003.obj"));
  EXPECT_NEAR(read_mesh(folder / "f/frame_000001.obj").positions[0].y, -9.81 * .05 * .05 / 2,
              1e-12);
}

TEST_F(Run, ThreadsDoNotChangeABit) {
  const std::string sample = std::string(WEFT_SAMPLE_SCENES) + "/patch_on_four_pins.json";
  const Json one = Json::parse(run_weft("run --time 0.2 --threads 1 --json " + sample).out);
  const Json three = Json::parse(run_weft("run --time 0.2 --threads 3 --json " + sample).out);
  EXPECT_EQ(one["state_hash"], three["state_hash"]);
  EXPECT_EQ(three["threads"], 3);
}

TEST_F(Run, FollowsPinMotionAndCollider) {
  Json json = falling_scene();
  json["cloths"][0]["pins"] =
      Json::parse(R"([{"vertices": [0], "motion": {"velocity": [0, 2, 0]}}])");
  json["colliders"] = Json::parse(R"([{"plane": {"normal": [0,1,0], "offset": -0.01}}])");
  ASSERT_EQ(run_weft("run --final " + (folder / "f.csv") + " " + scene(json)).code, 0);
  std::istringstream csv(read_text(folder / "f.csv"));
  std::string line;
  std::getline(csv, line);
  double lowest = 0, pin = 0;
  for (int i = 0; std::getline(csv, line); ++i) {
    double y = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%*d,%*d,%*f,%lf", &y), 1);
    if (i == 0) pin = y;
    lowest = std::min(lowest, y);
  }
  EXPECT_NEAR(pin, 0.2, 1e-12);
  EXPECT_GE(lowest, -0.01 - 1e-12);
}

}  // namespace
}  // namespace weft::io::test
