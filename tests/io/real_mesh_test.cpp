// Meshes that others made. Each is skipped where its package or folder is absent.
#include "io/mesh.h"

#include "support.h"

#include <set>

namespace weft::io::test {
namespace {

const std::string models = "/usr/share/assimp/models/";
const std::string shared = WEFT_SHARED_DATA "/";

struct Expected {
  const char* name;
  std::string path;
  size_t vertices, triangles, edges, isolated;
};

class RealMesh : public ::testing::TestWithParam<Expected> {};

TEST_P(RealMesh, HasTheKnownCounts) {
  const Expected& expected = GetParam();
  if (!std::filesystem::exists(expected.path)) GTEST_SKIP() << expected.path << " is absent";
  const Mesh mesh = read_mesh(expected.path);
  EXPECT_EQ(mesh.positions.size(), expected.vertices);
  EXPECT_EQ(mesh.triangles.size(), 3 * expected.triangles);
  std::set<std::pair<uint32_t, uint32_t>> edges;
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const uint32_t a = mesh.triangles[i];
    const uint32_t b = mesh.triangles[i % 3 == 2 ? i - 2 : i + 1];
    edges.insert({std::min(a, b), std::max(a, b)});
  }
  EXPECT_EQ(edges.size(), expected.edges);
  const std::set<uint32_t> used(mesh.triangles.begin(), mesh.triangles.end());
  EXPECT_EQ(mesh.positions.size() - used.size(), expected.isolated);
}

INSTANTIATE_TEST_SUITE_P(
    Files, RealMesh,
    ::testing::Values(Expected{"spot", shared + "spot.obj", 2930, 5856, 8784, 0},
                      Expected{"bunny", shared + "stanford-bunny.obj", 35947, 69451, 104288, 1113},
                      Expected{"teapot", shared + "teapot.obj", 3644, 6320, 9998, 0},
                      Expected{"wuson_obj", models + "OBJ/WusonOBJ.obj", 2117, 3732, 5804, 0},
                      Expected{"wuson_ply", models + "PLY/Wuson.ply", 11184, 3732, 11192, 0},
                      Expected{"cube_text", models + "PLY/cube.ply", 8, 12, 18, 0},
                      Expected{"cube_binary", models + "PLY/cube_binary.ply", 8, 12, 18, 0}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(RealMeshes, WusonPlyReportsItsHeaderLine) {
  const std::string path = models + "PLY/Wuson.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const Mesh mesh = read_mesh(path);
  ASSERT_EQ(mesh.warnings.size(), 1u);
  EXPECT_CONTAINS(mesh.warnings[0], "'Created'");
}

// The distribution's copy went through a line-end conversion and lacks 69 bytes.
TEST(RealMeshes, PondIsAPointCloudOrSaysWhatIsMissing) {
  const std::string path = models + "PLY/pond.0.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  try {
    const Mesh mesh = read_mesh(path);
    EXPECT_EQ(mesh.positions.size(), 70051u);
    EXPECT_TRUE(mesh.triangles.empty());
  } catch (const InputError& error) {
    EXPECT_CONTAINS(error.what(), "element vertex 70051 does not fit in the 2171512 bytes left");
  }
}

TEST(RealMeshes, EveryModelIsReadOrRefused) {
  if (!std::filesystem::exists(models)) GTEST_SKIP() << models << " is absent";
  for (const char* folder : {"OBJ", "PLY"}) {
    for (const auto& entry : std::filesystem::directory_iterator(models + folder)) {
      try {
        EXPECT_FALSE(read_mesh(entry.path().string()).positions.empty());
      } catch (const InputError& error) {
        EXPECT_CONTAINS(error.what(), entry.path().string());
      }
    }
  }
}

}  // namespace
}  // namespace weft::io::test
