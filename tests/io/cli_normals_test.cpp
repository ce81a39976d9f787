// weft run --normals: what it adds to frames, and that nothing changes without it.
#include "cli_support.h"

#include "io/mesh.h"

#include <cmath>
#include <cstring>
#include <regex>

namespace weft::io::test {
namespace {

struct Normals : ::testing::Test {
  TemporaryFolder folder;
  std::string run(const Json& json, const std::string& options, const std::string& name) const {
    const std::string out = folder / name;
    const Outcome outcome = run_weft("run --format obj,ply --out " + out + " " + options + " " +
                                     folder.write("s.json", json.dump()));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return out;
  }
};

/// Positions and normals of a binary PLY whose vertices are six doubles.
std::vector<std::array<double, 6>> vertices_of(const std::string& ply, size_t count) {
  const std::string end = "end_header\n";
  const size_t begin = ply.find(end) + end.size();
  std::vector<std::array<double, 6>> vertices(count);
  EXPECT_LE(begin + count * sizeof vertices[0], ply.size());
  std::memcpy(vertices.data(), ply.data() + begin, count * sizeof vertices[0]);
  return vertices;
}

/// The `vn` lines of an OBJ.
std::vector<double3> normals_of(const std::string& obj) {
  std::vector<double3> normals;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    double3 n{};
    if (std::sscanf(line.c_str(), "vn %lf %lf %lf", &n.x, &n.y, &n.z) == 3) normals.push_back(n);
  }
  return normals;
}

std::string without_normals(const std::string& obj) {
  const std::string no_lines = std::regex_replace(obj, std::regex("vn [^\n]*\n"), "");
  return std::regex_replace(no_lines, std::regex("//[0-9]+"), "");
}

TEST_F(Normals, OfAFlatGridPointAlongItsPositiveSide) {
  // 3 x 4 vertices, 1 m x 2 m in the plane z = 0; the triangles turn from +x to +y.
  const std::string out = run(falling_scene(), "--normals --time 0", "f");
  const std::string obj = read_text(out + "/frame_000000.obj");
  const auto normals = normals_of(obj);
  ASSERT_EQ(normals.size(), 12u);
  EXPECT_CONTAINS(obj, "\nf 1//1 2//2 6//6\n");
  const std::string ply = read_text(out + "/frame_000000.ply");
  EXPECT_CONTAINS(ply, "property double nx\nproperty double ny\nproperty double nz\n");
  const auto vertices = vertices_of(ply, 12);
  for (size_t i = 0; i < 12; ++i) {
    const double expected[] = {double(i % 4) / 3, double(i / 4), 0, 0, 0, 1};
    for (size_t k = 0; k < 6; ++k) EXPECT_NEAR(vertices[i][k], expected[k], 1e-12) << i;
    EXPECT_EQ(normals[i].x, vertices[i][3]) << i;
    EXPECT_EQ(normals[i].y, vertices[i][4]) << i;
    EXPECT_EQ(normals[i].z, vertices[i][5]) << i;
  }
}

TEST_F(Normals, TurnWithTheTransform) {
  Json json = falling_scene();
  json["cloths"][0]["transform"] =
      Json::parse(R"({"rotate": {"axis": [1,0,0], "degrees": 90}, "translate": [0,5,0]})");
  const std::string out = run(json, "--normals --time 0", "f");
  for (const double3 n : normals_of(read_text(out + "/frame_000000.obj"))) {
    EXPECT_NEAR(n.x, 0, 1e-12);
    EXPECT_NEAR(n.y, -1, 1e-12);
    EXPECT_NEAR(n.z, 0, 1e-12);
  }
}

TEST_F(Normals, OfNetworksAreZero) {
  Json json = falling_scene();
  json["cloths"].push_back(network_cloth());
  const std::string out = run(json, "--normals --time 0", "f");
  const auto normals = normals_of(read_text(out + "/frame_000000.obj"));
  ASSERT_EQ(normals.size(), 15u);
  for (size_t i = 12; i < 15; ++i) {
    EXPECT_EQ(normals[i].x, 0);
    EXPECT_EQ(normals[i].y, 0);
    EXPECT_EQ(normals[i].z, 0);
  }
}

TEST_F(Normals, AddToFramesWithoutChangingTheRest) {
  Json json = falling_scene();
  json["cloths"][0]["pins"] = {0};
  json["cloths"].push_back(network_cloth());
  const std::string with = run(json, "--normals", "with"), without = run(json, "", "without");
  for (int frame = 0; frame <= 6; ++frame) {
    const std::string name = "/frame_00000" + std::to_string(frame);
    const std::string obj = read_text(without + name + ".obj");
    EXPECT_EQ(obj.find("vn "), std::string::npos);
    EXPECT_EQ(without_normals(read_text(with + name + ".obj")), obj);
    const std::string ply = read_text(without + name + ".ply");
    EXPECT_EQ(ply.find("property double n"), std::string::npos);
    EXPECT_EQ(read_text(with + name + ".ply").size(),
              ply.size() + 3 * std::strlen("property double nx\n") + 15 * 3 * sizeof(double));
    const Mesh a = read_mesh(with + name + ".ply"), b = read_mesh(without + name + ".ply");
    EXPECT_EQ(a.triangles, b.triangles);
    ASSERT_EQ(a.positions.size(), b.positions.size());
    EXPECT_EQ(std::memcmp(a.positions.data(), b.positions.data(), 15 * sizeof(double3)), 0);
  }
}

TEST_F(Normals, HaveLengthOneWhileTheClothMoves) {
  Json json = falling_scene();
  json["cloths"][0]["pins"] = {0, 3};
  json["cloths"][0]["velocity"] = {0, 0, 1};
  const std::string out = run(json, "--normals", "f");
  const auto vertices = vertices_of(read_text(out + "/frame_000006.ply"), 12);
  bool turned = false;
  for (const auto& v : vertices) {
    EXPECT_NEAR(std::hypot(v[3], v[4], v[5]), 1, 1e-12);
    turned = turned || v[5] < 0.999;
  }
  EXPECT_TRUE(turned);
}

}  // namespace
}  // namespace weft::io::test
