// Files of a run that would take each other's place, or that of what it reads.
#include "cli_support.h"

#include "io/mesh.h"

namespace weft::io::test {
namespace {

class Paths : public testing::Test {
 protected:
  std::string scene(const Json& json) const { return folder.write("s.json", json.dump()); }
  void expect_refused(const std::string& options, const std::string& what) const {
    expect_failure(run_weft("run " + options + " " + folder / "s.json"), 2, what);
    EXPECT_EQ(folder.file_count(), files) << options;
  }
  TemporaryFolder folder;
  size_t files = 1;
};

TEST_F(Paths, FinalAndReportAreTwoFiles) {
  scene(falling_scene());
  expect_refused("--final " + (folder / "x") + " --report " + (folder / "x"),
                 "is also the file of --final");
  expect_refused("--final " + (folder / "x") + " --report " + (folder / "a/../x"),
                 "is also the file of --final");
  std::filesystem::create_symlink(folder / "x", folder / "link");
  expect_refused("--final " + (folder / "x") + " --report " + (folder / "link"),
                 "is also the file of --final");
}

TEST_F(Paths, FramesAreNotReplaced) {
  scene(falling_scene());
  const std::string out = "--out " + (folder / "f") + " ";
  expect_refused(out + "--final " + (folder / "f/frame_000003.obj"), "is also the file of --final");
  expect_refused(out + "--format png --report " + (folder / "f/frame_000000.png"),
                 "is also the file of --report");
  expect_refused(out + "--format pc2 --report " + (folder / "f/sheet.pc2"),
                 "is also the file of --report");
  expect_refused(out + "--format mp4 --report " + (folder / "f/s.mp4"),
                 "is also the file of --report");
  EXPECT_EQ(run_weft("run " + out + "--final " + (folder / "f/frame_000003.csv") + " " +
                     (folder / "s.json"))
                .code,
            0);
}

TEST_F(Paths, WhatIsReadStays) {
  Json json = falling_scene();
  folder.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  json["cloths"][0] = {
      {"name", "sheet"}, {"mass", 1}, {"stiffness", 1}, {"mesh", {{"file", "sheet.obj"}}}};
  scene(json);
  files = 2;
  expect_refused("--report " + (folder / "s.json"), "is also the scene");
  expect_refused("--final " + (folder / "sheet.obj"), "is also a mesh that the scene reads");
  expect_refused("--format pc2 --out " + folder.string(), "is also a mesh that the scene reads");
}

// A frame that is written through a link would replace what the link names.
TEST_F(Paths, FramesAreNotWrittenThroughLinks) {
  const std::string file = scene(falling_scene());
  std::filesystem::create_directory(folder / "f");
  std::filesystem::create_symlink("../s.json", folder / "f/frame_000002.obj");
  std::filesystem::create_symlink("frame_000000.png", folder / "f/frame_000001.png");
  const std::string before = read_text(file);
  const std::string out = "run --out " + (folder / "f") + " ";
  expect_failure(run_weft(out + file), 2, "is a symbolic link");
  expect_failure(run_weft(out + "--format png " + file), 2, "frame_000001.png' is a symbolic link");
  EXPECT_EQ(read_text(file), before);
  EXPECT_EQ(run_weft(out + "--format ply " + file).code, 0) << "no link is in the way of these";
  std::filesystem::create_symlink("../s.json", folder / "f/sheet.pc2");
  std::filesystem::create_directory(folder / "f/s.mp4");
  expect_failure(run_weft(out + "--format pc2 " + file), 2, "sheet.pc2' is a symbolic link");
  expect_failure(run_weft(out + "--format mp4 " + file), 2, "s.mp4' is not a file");
  EXPECT_EQ(read_text(file), before);
  std::filesystem::create_symlink("b", folder / "a");
  std::filesystem::create_symlink("a", folder / "b");
  expect_failure(run_weft("run --final " + (folder / "a") + " " + file), 3, "symbolic links");
}

TEST_F(Paths, TheFolderOfFramesIsNoOtherFile) {
  scene(falling_scene());
  expect_refused("--out " + (folder / "x") + " --final " + (folder / "x"),
                 "also the file of --final");
  expect_refused("--out " + (folder / "x/y") + " --report " + (folder / "x"),
                 "also the file of --report");
  const std::string name(250, 'n');
  EXPECT_EQ(run_weft("run --final " + (folder / name) + " " + (folder / "s.json")).code, 0)
      << "as long as a name may be";
}

TEST_F(Paths, ManyCachesNeedManyOpenFiles) {
  Json json = falling_scene();
  for (int i = 0; i < 99; ++i) json["cloths"].push_back(json["cloths"][0]);
  const std::string run =
      "run --time 0.02 --format pc2 --out " + (folder / "f") + " " + scene(json);
  EXPECT_EQ(run_weft(run, "ulimit -S -n 60; exec ").code, 0)
      << "the limit is raised as far as may be";
  EXPECT_TRUE(std::filesystem::exists(folder / "f/sheet_100.pc2"));
  std::filesystem::remove_all(folder / "f");
  expect_failure(run_weft(run, "ulimit -n 60; exec "), 3, "100 cloths are as many open files");
  EXPECT_TRUE(std::filesystem::is_empty(folder / "f"));
}

TEST_F(Paths, CachesFarFromZeroAreCoarseAndSaySo) {
  Json json = falling_scene();
  const std::string run = "run --time 0.02 --format pc2 --out " + (folder / "f") + " ";
  EXPECT_EQ(run_weft(run + scene(json)).err, "");
  json["cloths"][0]["transform"] = {{"translate", {0, 1e6, 0}}};
  const Outcome far = run_weft(run + scene(json));
  EXPECT_EQ(far.code, 0);
  EXPECT_CONTAINS(far.err, "warning: cloth 'sheet' is 1e+06 m from zero");
  EXPECT_CONTAINS(far.err, "0.0625 m apart");
}

TEST_F(Paths, DevicesTakeAll) {
  const std::string file = scene(falling_scene());
  EXPECT_EQ(run_weft("run --final /dev/null --report /dev/null " + file).code, 0);
}

TEST_F(Paths, CachesKeepOutOfTheWayOfFramesAndOfEachOther) {
  Json json = falling_scene();
  json["cloths"][0]["name"] = "frame_000000";
  for (const char* name : {"Flag", "flag"}) {
    json["cloths"].push_back(grid_cloth());
    json["cloths"].back()["name"] = name;
  }
  const std::string to = " --out " + (folder / "f") + " ";
  ASSERT_EQ(run_weft("run --time 0 --format obj,pc2" + to + scene(json)).code, 0);
  EXPECT_EQ(read_mesh(folder / "f/frame_000000.obj").positions.size(), 36u) << "the frame";
  for (const char* name : {"frame_000000_2", "Flag", "flag_2"}) {
    EXPECT_EQ(read_mesh(folder / "f/" + name + ".obj").positions.size(), 12u) << name;
  }
}

TEST_F(Paths, FramesFarFromZeroAreAsFineAsTheCloth) {
  Json json = falling_scene();
  json["solver"]["precision"] = "float32";
  json["cloths"][0]["transform"] = {{"translate", {10000, 0, 0}}};
  const std::string to = " --out " + (folder / "f") + " --final " + (folder / "f.csv") + " ";
  ASSERT_EQ(run_weft("run --format obj,ply" + to + scene(json)).code, 0);
  const std::string final_state = read_text(folder / "f.csv");
  const std::string line = final_state.substr(final_state.find("\n0,1,") + 5);
  const double x = std::stod(line);
  EXPECT_EQ(read_mesh(folder / "f/frame_000006.obj").positions[1].x, x) << line;
  EXPECT_EQ(read_mesh(folder / "f/frame_000006.ply").positions[1].x, x);
  EXPECT_NE(x, double(float(x))) << "a float could not hold it";
}

}  // namespace
}  // namespace weft::io::test
