// Meshes as people have them, through files and the program: what a scene weighs, where grains come
// to lie, what is said.
#include "cli_support.h"

#include "io/mesh.h"

#include <chrono>
#include <cmath>
#include <sstream>

namespace weft::io::test {
namespace {

struct Meshes : ::testing::Test {
  TemporaryFolder folder;
  std::string scene(const Json& json) const { return folder.write("s.json", json.dump()); }

  static Json mesh_scene(const Json& mesh) {
    return scene_of({{"name", "m"}, {"density", 1}, {"stiffness", 100}, {"mesh", mesh}});
  }
  Json run(const Json& json, const std::string& options = "") const {
    const Outcome outcome = run_weft("run --json " + options + " " + scene(json));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
  /// Rows of --final: x, y, z.
  std::vector<double3> final_of(const Json& json) const {
    run(json, "--final " + (folder / "f.csv"));
    std::istringstream csv(read_text(folder / "f.csv"));
    std::vector<double3> rows;
    std::string line;
    std::getline(csv, line);
    while (std::getline(csv, line)) {
      double3 x;
      EXPECT_EQ(std::sscanf(line.c_str(), "%*d,%*d,%lf,%lf,%lf", &x.x, &x.y, &x.z), 3);
      rows.push_back(x);
    }
    return rows;
  }
};

/// A U of area 5: two towers of 1 x 2 on a foot of 3 x 1... as one face.
const char* const u_vertices =
    "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n";
constexpr int u_corners = 8;
constexpr double u_area = 3 * 1 + 2 * 2;

std::string rotated_face(int first, bool ply) {
  std::string line = ply ? "8" : "f";
  for (int k = 0; k < u_corners; ++k) {
    line += " " + std::to_string((first + k) % u_corners + (ply ? 0 : 1));
  }
  return line + "\n";
}

TEST_F(Meshes, AConcaveClothWeighsItsAreaFromAnyFirstCorner) {
  std::string state;
  for (int first = 0; first < u_corners; ++first) {
    for (const bool ply : {false, true}) {
      std::string text;
      if (ply) {
        text =
            "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar short "
            "vertex_index\nend_header\n";
        std::istringstream lines(u_vertices);
        for (std::string line; std::getline(lines, line);) text += line.substr(2) + "\n";
        text += rotated_face(first, true);
      } else {
        text = u_vertices + rotated_face(first, false);
      }
      folder.write("u", text);
      Json json = mesh_scene({{"file", "u"}});
      json["gravity"] = {0, -10, 0};
      json["time"] = {{"duration", 0.1}};
      const Json report = run(json);
      // Free fall: momentum is m g t.
      EXPECT_NEAR(report["momentum"][1].get<double>(), -u_area * 10 * 0.1, 1e-5) << first;
      if (state.empty()) state = report["state_hash"];
      EXPECT_EQ(report["state_hash"], state) << "from corner " << first << ", ply " << ply;
    }
  }
}

TEST_F(Meshes, GrainsFallThroughTheNotchOfAConcaveCollider) {
  for (int first = 0; first < u_corners; ++first) {
    std::string text = u_vertices;
    std::istringstream lines(u_vertices);
    for (std::string line; std::getline(lines, line);)
      text += line.substr(0, line.size() - 1) + "-1\n";
    std::string front = rotated_face(first, false), back = "f";
    for (int k = u_corners; k-- > 0;) {
      back += " " + std::to_string((first + k) % u_corners + 9);
    }
    text += front + back + "\n";
    for (int k = 0; k < u_corners; ++k) {
      const int a = k + 1, b = (k + 1) % u_corners + 1;
      text += "f " + std::to_string(b) + " " + std::to_string(a) + " " + std::to_string(a + 8) +
              " " + std::to_string(b + 8) + "\n";
    }
    folder.write("u.obj", text);
    Json json = scene_of(
        {{"name", "grains"},
         {"mass", 0.1},
         {"network",
          {{"positions", {{1.5, 3.5, -0.5}, {0.5, 3.5, -0.5}}}, {"springs", Json::array()}}}});
    json["time"] = {{"duration", 1.5}};
    json["colliders"] = {{{"mesh", {{"file", "u.obj"}, {"closed", true}, {"thickness", 0.01}}}}};
    const auto x = final_of(json);
    ASSERT_EQ(x.size(), 2u);
    EXPECT_NEAR(x[0].y, 1.01, 1e-3) << "on the bottom of the notch, first corner " << first;
    EXPECT_NEAR(x[1].y, 3.01, 1e-3) << "on a tower";
  }
}

TEST_F(Meshes, WhatCannotBeCutIsRefusedByItsNumber) {
  const auto refusal = [&](const std::string& text) {
    folder.write("bad", text);
    return run_weft("check " + scene(mesh_scene({{"file", "bad"}})));
  };
  const std::string five = "v 0 0 0\nv 3 3 0\nv 3 0 0\nv 0 1 0\nv 9 9 0\nf 1 3 2\n";
  expect_failure(refusal(five + "f 1 2 3 4\n"), 2, "line 7: the face (number 1 from 0) crosses");
  expect_failure(refusal(five + "v 1 0 0\nv 2 0 0\nf 1 6 7 3\n"), 2,
                 "line 9: the face (number 1 from 0) has no area");
  expect_failure(refusal(five + "f 1 2 3 2\n"), 2, "line 7: the face names vertex 2 twice");
  expect_failure(refusal("f 1 2 3 4\n" + five), 2, "line 1: the face (number 0 from 0) crosses");
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n3 3 0\n3 0 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n";
  expect_failure(refusal(ply), 2, "face 1: the face crosses itself");
}

const std::string cube_faces =
    "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n";
std::string cube(double x, double half, bool inverted) {
  std::ostringstream text;
  for (int v = 0; v < 8; ++v) {
    text << "v " << x + (v & 1 ? half : -half) * (inverted ? -1 : 1) << " "
         << (v & 2 ? half : -half) << " " << (v & 4 ? half : -half) << "\n";
  }
  return text.str() + cube_faces;
}

TEST_F(Meshes, AnInvertedPieceIsNamedByTheFacesOfItsFile) {
  Json json = falling_scene();
  json["colliders"] = {{{"mesh", {{"file", "c.obj"}, {"closed", true}}}}};
  folder.write("c.obj", cube(0, 1, false) + cube(5, 0.5, true));
  expect_failure(run_weft("run " + scene(json)), 2,
                 "$.colliders[0]: the piece of triangle 12 (face 6 of the file, from 0)");
  folder.write("c.obj", cube(0, 1, false) + cube(0, 0.5, true));
  EXPECT_EQ(run_weft("check " + scene(json)).code, 0) << "a cavity";
}

TEST_F(Meshes, WeldDistanceClosesSeamsOfClothsAndColliders) {
  const std::string two =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1.0001 0 0\nv 2 0 0\nv 2 1 0\nv 1.0001 1 0\n"
      "f 1 2 3 4\nf 5 6 7 8\n";
  folder.write("two.obj", two);
  Json json = mesh_scene({{"file", "two.obj"}, {"weld_distance", 0.001}, {"bend", true}});
  json["cloths"][0]["pins"] = {0, 3};
  json["cloths"][0]["velocities"] = Json::array();
  for (int v = 0; v < 8; ++v) json["cloths"][0]["velocities"].push_back({0, 0, 0.1 * v});
  json["time"] = {{"duration", 0.5}};
  const Json report = run(json, "--out " + (folder / "out"));
  EXPECT_EQ(report["particles"], 6);
  const auto x = final_of(json);
  ASSERT_EQ(x.size(), 8u) << "vertices as the file has them";
  EXPECT_EQ(x[1].y, x[4].y);
  EXPECT_EQ(x[2].z, x[7].z);
  EXPECT_NE(x[5].y, 0);
  const Mesh frame = read_mesh(folder / "out/frame_000030.obj");
  ASSERT_EQ(frame.positions.size(), 8u);
  EXPECT_EQ(frame.triangles, read_mesh(folder / "two.obj").triangles);
  EXPECT_EQ(frame.positions[2].y, frame.positions[7].y);
  json["cloths"][0]["pins"] = {4, 7};
  EXPECT_EQ(final_of(json)[1].x, 1) << "a pin on either vertex of a seam holds it";

  json["cloths"][0]["mesh"]["weld_distance"] = -1;
  expect_failure(run_weft("check " + scene(json)), 2, "$.cloths[0].mesh.weld_distance: -1");

  std::string open = cube(0, 1, false);
  const std::string from = "f -7 -5 -1 -3\n";
  open.replace(open.find(from), from.size(),
               "v 1 -1.001 -1\nv 1 1 -1\nv 1 -1 1\nv 1 1 1\nf -4 -3 -1 -2\n");
  folder.write("c.obj", open);
  json = falling_scene();
  json["colliders"] = {{{"mesh", {{"file", "c.obj"}, {"closed", true}}}}};
  expect_failure(run_weft("check " + scene(json)), 2, "0.001 m apart");
  json["colliders"][0]["mesh"]["weld_distance"] = 0.0011;
  EXPECT_EQ(run_weft("check " + scene(json)).code, 0);
}

TEST_F(Meshes, LinesBesideFacesAreSprings) {
  folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 0\nf 1 2 3 4\nl 2 4\nl 3 5/1\n");
  Json json = mesh_scene({{"file", "m.obj"}});
  Json check = Json::parse(run_weft("check --json " + scene(json)).out);
  EXPECT_EQ(check["springs"], 7) << "5 edges and both lines";
  folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nl 1 2 -2\nl 4 2\n");
  check = Json::parse(run_weft("check --json " + scene(json)).out);
  EXPECT_EQ(check["springs"], 6) << "l 1 2 and 2 3 are edges";
  const Outcome outcome = run_weft("run " + scene(json));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_CONTAINS(outcome.err, "warning: ");
  EXPECT_CONTAINS(outcome.err,
                  "2 springs join two vertices that an edge or a spring joins already");
  for (const auto& [line, text] :
       std::vector<std::pair<std::string, std::string>>{{"l 1", "the line has 1 vertices"},
                                                        {"l 1 9", "line index 9 is out of range"},
                                                        {"l 1 x", "line index 'x' is not a number"},
                                                        {"l 2 2", "joins vertex 2 to itself"}}) {
    folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n" + line + "\n");
    expect_failure(run_weft("check " + scene(json)), 2, text);
  }
}

// The frames of a network are lines alone, or edges: read back they are the same network.
TEST_F(Meshes, FramesOfNetworksCanBeReadBack) {
  Json json = scene_of(network_cloth());
  Json second = network_cloth();
  second["name"] = "other";
  second["transform"] = {{"translate", {0, 0, 2}}};
  json["cloths"].push_back(second);
  json["time"] = {{"duration", 0.1}};
  run(json, "--format obj,ply,pc2 --out " + (folder / "out"));
  const std::string frame = read_text(folder / "out/frame_000006.obj");
  EXPECT_CONTAINS(frame, "l 1 2\n");
  EXPECT_CONTAINS(frame, "l 4 5\n");
  EXPECT_CONTAINS(frame, "l 4 6\n") << "counted from the vertices of the second network";
  for (const char* file : {"out/frame_000006.obj", "out/frame_000006.ply"}) {
    Json again =
        scene_of({{"name", "net"}, {"mass", 2}, {"stiffness", 100}, {"mesh", {{"file", file}}}});
    again["time"] = {{"duration", 0}};
    const Json check = Json::parse(run_weft("check --json " + scene(again)).out);
    EXPECT_EQ(check["particles"], 6) << file;
    EXPECT_EQ(check["springs"], 6) << file;
    run(again, "--out " + (folder / "back"));
    const Mesh a = read_mesh(folder / file), b = read_mesh(folder / "back/frame_000000.obj");
    ASSERT_EQ(a.positions.size(), b.positions.size());
    for (size_t i = 0; i < a.positions.size(); ++i) {
      EXPECT_NEAR(a.positions[i].y, b.positions[i].y, 1e-6);
      EXPECT_NEAR(a.positions[i].z, b.positions[i].z, 1e-6);
    }
    ASSERT_EQ(a.lines.size(), b.lines.size());
    for (size_t i = 0; i < a.lines.size(); ++i) {
      EXPECT_EQ(a.lines[i].a, b.lines[i].a);
      EXPECT_EQ(a.lines[i].b, b.lines[i].b);
    }
  }
  EXPECT_EQ(read_mesh(folder / "out/other.obj").lines.size(), 3u);
  Json again = scene_of(
      {{"name", "n"}, {"density", 2}, {"stiffness", 1}, {"mesh", {{"file", "out/net.obj"}}}});
  expect_failure(run_weft("check " + scene(again)), 2, "no triangles");
}

TEST_F(Meshes, RunSaysWhatCheckSaysAboutFabricsAndColliders) {
  folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 3 2 1\nwhat 1\n");
  folder.write("c.obj", "v 0 -9 0\nv 1 -9 0\nv 1 -9 1\nv 5 -9 5\nf 1 2 3\nf 3 1 2\n");
  Json json = mesh_scene({{"file", "m.obj"}});
  json["colliders"] = {{{"plane", {{"normal", {0, 1, 0}}, {"offset", -20}}}},
                       {{"mesh", {{"file", "c.obj"}}}}};
  const Outcome outcome = run_weft("run " + scene(json));
  EXPECT_EQ(outcome.code, 0);
  for (const char* text :
       {"cloth 'm': 1 triangles are given again, the first is 1, which is triangle 0",
        "cloth 'm': 1 lines with an unknown keyword",
        "$.colliders[1]: 1 triangles are given again, the first is 1, which is triangle 0"}) {
    EXPECT_CONTAINS(outcome.err, text);
    EXPECT_CONTAINS(run_weft("check " + scene(json)).out, text);
  }
}

TEST_F(Meshes, NamesOfOutputsAreTriedBeforeTheRun) {
  const std::string file = scene(falling_scene());
  const std::string longest(255, 'n'), too_long(256, 'n');
  EXPECT_EQ(run_weft("run --final " + (folder / longest) + " " + file).code, 0);
  for (const char* option : {"--final ", "--report "}) {
    const auto start = std::chrono::steady_clock::now();
    expect_failure(run_weft("run --time 100000 " + (option + (folder / too_long)) + " " + file), 3,
                   "cannot be opened (File name too long)");
    expect_failure(run_weft("run --time 100000 " + (option + (folder / "none/x")) + " " + file), 3,
                   "No such file or directory");
    expect_failure(run_weft("run --time 100000 " + (option + folder.string()) + " " + file), 3,
                   "Is a directory");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  }
}

// A seam of a hundredth of a millimetre opens by a few of them; the cloth is as it should be.
TEST_F(Meshes, LongSpringsAreMeasuredAgainstTheirCloth) {
  Json json = scene_of(Json::parse(R"({"name": "net", "mass": 1, "stiffness": 100,
      "pins": [0, 2], "network": { "positions": [[0,0,0],[1,0,0],[1.00001,0,0]],
                                   "springs": [[0,1],[1,2,5]] } })"));
  json["time"] = {{"duration", 0.2}};
  Outcome outcome = run_weft("run --json " + scene(json));
  EXPECT_GT(Json::parse(outcome.out)["largest_stretch"].get<double>(), 10);
  EXPECT_EQ(outcome.err.find("times as long"), std::string::npos) << outcome.err;
  json["cloths"][0]["velocities"] = {{0, 0, 0}, {0, 900, 0}, {0, 0, 0}};
  json["time"] = {{"duration", 0.0167}};
  outcome = run_weft("run " + scene(json));
  EXPECT_CONTAINS(outcome.err, "times as long");
}

}  // namespace
}  // namespace weft::io::test
