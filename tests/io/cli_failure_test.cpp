// Runs that must fail, and what they leave behind: nothing.
#include "cli_support.h"

#include "io/point_cache.h"

#include <sys/stat.h>
#include <unistd.h>

#include <chrono>

namespace weft::io::test {
namespace {

struct Failure : ::testing::Test {
  TemporaryFolder folder;
  std::string scene(const Json& json) const { return folder.write("s.json", json.dump()); }
  std::string outputs() const {
    return " --out " + (folder / "frames") + " --final " + (folder / "f.csv") + " --report " +
           (folder / "r.json") + " ";
  }
  void expect_only_the_scene() const {
    EXPECT_EQ(folder.file_count(), 1u);
    EXPECT_FALSE(std::filesystem::exists(folder / "frames"));
  }
};

TEST_F(Failure, RejectedSceneWritesNothing) {
  Json json = falling_scene();
  json["cloths"][0]["grid"]["rows"] = 0;
  for (const char* command : {"run", "check", "plan"}) {
    const std::string more = std::string(command) == "run" ? outputs() : " ";
    expect_failure(run_weft(command + more + scene(json)), 2,
                   "s.json: $.cloths[0].grid.rows: 0 is out of range");
    expect_only_the_scene();
  }
  folder.write("s.json", "{");
  expect_failure(run_weft("run " + outputs() + (folder / "s.json")), 2, "is not JSON");
  expect_only_the_scene();
}

TEST_F(Failure, WhatTheLibraryRefusesNamesTheCloth) {
  Json json = falling_scene();
  Json cloth{{"name", "m"}, {"mass", 1}, {"stiffness", 1}, {"mesh", {{"file", "s.obj"}}}};
  json["cloths"].push_back(cloth);
  const std::string path = folder.write("s.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
  expect_failure(run_weft("run" + outputs() + scene(json)), 2, "s.json: $.cloths[1]: triangle 1");
  std::filesystem::remove(path);
  expect_only_the_scene();
}

TEST_F(Failure, AStepBeyondTheBoundIsRefused) {
  Json json = falling_scene();
  json["time"] = {{"frame", 0.5}, {"substeps", 2}};
  const Outcome outcome = run_weft("run" + outputs() + scene(json));
  expect_failure(outcome, 2, "s.json: $.time.substeps: 2 is too few");
  EXPECT_CONTAINS(outcome.err, "cloth 'sheet', spring ");
  expect_only_the_scene();
  const size_t at = outcome.err.find("at least ") + 9;
  const int enough = std::atoi(outcome.err.c_str() + at);
  json["time"]["substeps"] = enough;
  EXPECT_EQ(run_weft("run --time 0.5 " + scene(json)).code, 0);
  json["time"]["substeps"] = enough - 1;
  EXPECT_EQ(run_weft("run --time 0.5 " + scene(json)).code, 2);
}

TEST_F(Failure, DivergenceStopsWithExitCode3) {
  Json json = falling_scene();
  json["time"] = {{"frame", 0.5}, {"substeps", 1}, {"duration", 5000}};
  json["solver"] = {{"unsafe", true}};
  json["cloths"][0]["pins"] = {0};
  const std::string report = folder / "r.json";
  const Outcome outcome = run_weft("run --backend omp --report " + report + " --final " +
                                   (folder / "f.csv") + " " + scene(json));
  expect_failure(outcome, 3, "stopped in frame");
  const Json events = Json::parse(read_text(report))["events"];
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.back()["type"], "non_finite");  // stretched springs are told of before
  EXPECT_EQ(events.back()["cloth"], 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "f.csv"));
}

// A frame of a hundred million substeps is not waited for.
TEST_F(Failure, ASignalEndsALongFrame) {
  Json json = falling_scene();
  json["cloths"][0]["stiffness"] = 9e15;
  json["time"]["duration"] = 1;
  const std::string run = "run --format pc2 --out " + (folder / "f") + " " + scene(json);
  const auto begin = std::chrono::steady_clock::now();
  expect_failure(run_weft(run, "exec timeout --preserve-status -s TERM 0.5 "), 3,
                 "stopped in the middle of frame 1 of 60 (signal 15");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  EXPECT_EQ(read_point_cache(folder / "f/sheet.pc2").samples, 1u) << "what there was is whole";
}

TEST_F(Failure, APipeWithAReaderGetsAll) {
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const Outcome outcome = run_weft("run --final " + pipe + " " + scene(falling_scene()),
                                   "cat " + pipe + " >" + (folder / "got") + " & exec ");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (int i = 0; i < 100 && read_text(folder / "got").empty(); ++i) ::usleep(20000);
  EXPECT_EQ(read_text(folder / "got").rfind("cloth,vertex,", 0), 0u);
}

// Nobody reads from the pipe.
TEST_F(Failure, ASignalEndsAWriteThatWaits) {
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  expect_failure(run_weft("run --final " + pipe + " " + scene(falling_scene()),
                          "exec timeout --preserve-status -s HUP 0.5 "),
                 3, "stopped in the middle of the run (signal 1");
}

/// What standard streams the program gets, as a shell writes it; it says something on the second.
struct Streams : Failure {
  int run_with(const std::string& streams) const {
    Json json = falling_scene();
    json["cloths"][0]["grid"]["rows"] = 1;
    json["wind"] = {{"velocity", {1, 0, 0}}};
    const std::string command = std::string(WEFT_PROGRAM) + " run --format pc2 --out " +
                                (folder / "f") + " " + scene(json) + " " + streams;
    return std::system(command.c_str());
  }
};

TEST_F(Streams, ThatAreClosedDoNotBecomeFiles) {
  EXPECT_EQ(run_with("<&- 2>&- >/dev/null"), 0);
  EXPECT_EQ(read_point_cache(folder / "f/sheet.pc2").samples, 7u) << "no message stands in it";
}

TEST_F(Streams, ThatNobodyReadsLeaveNothingHalfWritten) {
  EXPECT_EQ(run_with("2>&1 >/dev/null | true"), 0);
  for (const auto& entry : std::filesystem::directory_iterator(folder / "f")) {
    EXPECT_EQ(entry.path().filename().string()[0], 's') << entry.path();
  }
}

// Forces that leave the range of floats within the last step.
TEST_F(Failure, VelocitiesThatAreNotFiniteAreAnError) {
  const Json json = Json::parse(R"({"weft": 1, "gravity": [0, -9e17, 0],
    "wind": {"velocity": [1, 0, 0]},
    "colliders": [{"sphere": {"center": [0, 0, 0], "radius": 0.3}}],
    "cloths": [{"name": "a", "mass": 1, "stiffness": 10,
      "grid": {"rows": 4, "columns": 4, "width": 1, "height": 1, "stencil": "classic12"}}]})");
  expect_failure(run_weft("run --time 0.01 --final " + (folder / "f.csv") + " " + scene(json)), 3,
                 "ends with velocities that are not finite");
  EXPECT_FALSE(std::filesystem::exists(folder / "f.csv"));
}

// Names are printed, and a terminal obeys some characters.
TEST_F(Failure, ControlCharactersDoNotReachTheTerminal) {
  Json json = falling_scene();
  json["cloths"][0]["name"] = "a\x1b[2J\nweft: b\u009b";
  json["cloths"][0]["grid"]["rows"] = 1;
  json["wind"] = {{"velocity", {1, 0, 0}}};
  const Outcome check = run_weft("check " + scene(json));
  EXPECT_EQ(check.code, 0);
  const Outcome run = run_weft("run " + scene(json));
  for (const std::string& text : {check.out, run.err}) {
    EXPECT_CONTAINS(text, "a?[2J weft: b??");
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find("\xc2\x9b"), std::string::npos);
  }
}

TEST_F(Failure, OptionsThatWouldDoNothingAreRefused) {
  const std::string file = scene(falling_scene());
  const std::string run = "run --out " + (folder / "f") + " ";
  expect_failure(run_weft(run + "--size 64x64 " + file), 2, "--size: '64x64' is about pictures");
  expect_failure(run_weft(run + "--format pc2 --normals " + file), 2, "--normals: is about meshes");
  expect_only_the_scene();
}

TEST_F(Failure, UnwritablePlacesAreFoundBeforeSimulating) {
  Json json = falling_scene();
  json["time"]["duration"] = 1e9;
  const std::string file = scene(json);
  const std::string below = file + "/below";
  expect_failure(run_weft("run --final " + below + " " + file), 3, below);
  expect_failure(run_weft("run --report " + below + " " + file), 3, below);
  expect_failure(run_weft("run --out " + below + " " + file), 2, "is also the scene");
  expect_failure(run_weft("run --out " + file + " " + file), 2, "is also the scene");
  expect_failure(run_weft("run --final " + (folder / "no/f.csv") + " " + file), 3, "no/f.csv");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST_F(Failure, AFullDiskLeavesNothingHalfWritten) {
  Json json = falling_scene();
  json["cloths"][0]["grid"]["rows"] = 100;
  const std::string file = scene(json);
  // 4 kB: less than a frame, more than the 1 kB that clang's OpenMP runtime keeps in a file.
  for (const char* option : {"--final ", "--out "}) {
    const Outcome outcome =
        run_weft("run " + std::string(option) + (folder / "x") + " " + file, "ulimit -f 8; exec ");
    expect_failure(outcome, 3, "cannot be written");
    EXPECT_EQ(folder.file_count(), 1u) << option;
  }
  expect_failure(run_weft("run --report /dev/full " + file), 3, "/dev/full");
  EXPECT_EQ(
      std::system((std::string(WEFT_PROGRAM) + " check " + file + " >/dev/full 2>&1").c_str()),
      3 << 8);
}

TEST_F(Failure, ASignalEndsTheRunBetweenFrames) {
  Json json = falling_scene();
  json["time"]["duration"] = 1e9;
  const Outcome outcome = run_weft("run --report " + (folder / "r.json") + " " + scene(json),
                                   "timeout --preserve-status -s TERM 0.5 ");
  expect_failure(outcome, 3, "signal 15");
  EXPECT_GT(Json::parse(read_text(folder / "r.json"))["frames"], 0);
}

}  // namespace
}  // namespace weft::io::test
