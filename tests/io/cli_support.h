// Running the program as a user does.
#pragma once

#include "scene_support.h"

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

namespace weft::io::test {

struct Outcome {
  int code;  ///< exit code, or 128 + signal
  std::string out, err;
};

/// `before` is shell text in front of the program, such as "ulimit -f 1; exec ".
inline Outcome run_weft(const std::string& arguments, const std::string& before = "exec ") {
  const TemporaryFolder folder;
  // The program takes the shell's process number, under which LLVM's OpenMP runtime may find a file
  // of a process that was killed.
  const std::string command = "rm -f /dev/shm/__KMP_REGISTERED_LIB_$$_*; " + before + WEFT_PROGRAM +
                              " " + arguments + " >" + (folder / "out") + " 2>" + (folder / "err");
  const int status = std::system(command.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, read_text(folder / "out"), read_text(folder / "err")};
}

/// Expects this exit code, nothing on standard output, and one line on standard error with `text`.
inline void expect_failure(const Outcome& outcome, int code, const std::string& text) {
  EXPECT_EQ(outcome.code, code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_CONTAINS(outcome.err, text);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

/// A scene of a file with the paths of its meshes from the root; null where a mesh is missing on
/// this machine.
inline Json sample_scene(const std::filesystem::path& file) {
  Json scene = Json::parse(read_text(file.string()));
  for (Json& cloth : scene["cloths"]) {
    if (!cloth.contains("mesh")) continue;
    const auto mesh = file.parent_path() / cloth["mesh"]["file"].get<std::string>();
    if (!std::filesystem::exists(mesh)) return {};
    cloth["mesh"]["file"] = mesh.string();
  }
  return scene;
}

/// A small sheet that falls freely: substeps "auto", 6 frames of 1/60 s.
inline Json falling_scene() {
  Json scene = scene_of(grid_cloth());
  scene["time"] = {{"duration", 0.1}};
  scene["solver"] = {{"precision", "float64"}};
  return scene;
}

}  // namespace weft::io::test
