// Frames with normals, and that those without have not changed.
#include "io/mesh.h"
#include "io/surface.h"

#include "support.h"

#include <bit>
#include <cstring>

namespace weft::io::test {
namespace {

Surface two_parts(bool normals) {
  Surface surface;
  surface.positions = {{0.1, 1.0 / 3, 0}, {1, 0, 0}, {0, 1, 0}, {5, 6, 7}, {8, 9, 10}};
  surface.triangles = {{0, 1, 2}};
  surface.edges = {{3, 4}};
  surface.parts = {{"sheet", 0, 3, 0, 1, 0, 0}, {"net", 3, 2, 1, 0, 0, 1}};
  if (normals) surface.normals = {{0, 0, 1}, {0.6, 0, 0.8}, {0.1, 0.2, 1.0 / 3}, {}, {}};
  return surface;
}

const char* const plain_obj =
    "o sheet\nv 0.1 0.33333334 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    "o net\nv 5 6 7\nv 8 9 10\nl 4 5\n";
const char* const obj_with_normals =
    "o sheet\nv 0.1 0.33333334 0\nv 1 0 0\nv 0 1 0\n"
    "vn 0 0 1\nvn 0.6 0 0.8\nvn 0.1 0.2 0.33333334\nf 1//1 2//2 3//3\n"
    "o net\nv 5 6 7\nv 8 9 10\nvn 0 0 0\nvn 0 0 0\nl 4 5\n";

std::string ply_header(const std::string& real, bool normals) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex 5\n";
  for (const char* name : {"x", "y", "z"}) text += "property " + real + " " + name + "\n";
  for (const char* name : {"nx", "ny", "nz"}) {
    if (normals) text += "property " + real + " " + name + "\n";
  }
  return text +
         "element face 1\nproperty list uchar int vertex_indices\n"
         "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n";
}

template <class Real>
void append(std::string& bytes, double3 values) {
  for (const double value : {values.x, values.y, values.z}) {
    const auto rounded = static_cast<Real>(value);
    char raw[sizeof rounded];
    std::memcpy(raw, &rounded, sizeof rounded);
    bytes.append(raw, sizeof raw);
  }
}

template <class Real>
std::string expected_ply(const std::string& real, bool normals) {
  const Surface surface = two_parts(normals);
  std::string bytes = ply_header(real, normals);
  for (size_t i = 0; i < 5; ++i) {
    append<Real>(bytes, surface.positions[i]);
    if (normals) append<Real>(bytes, surface.normals[i]);
  }
  bytes += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  return bytes + std::string("\3\0\0\0\4\0\0\0", 8);
}

struct NormalsWriter : ::testing::Test {
  std::string obj(bool normals, Precision precision) const {
    write_obj(folder / "a.obj", two_parts(normals), precision);
    return read_text(folder / "a.obj");
  }
  std::string ply(bool normals, Precision precision) const {
    write_ply(folder / "a.ply", two_parts(normals), precision);
    return read_text(folder / "a.ply");
  }
  TemporaryFolder folder;
};

TEST_F(NormalsWriter, ObjNumbersNormalsLikeVertices) {
  EXPECT_EQ(obj(true, Precision::float32), obj_with_normals);
  EXPECT_CONTAINS(obj(true, Precision::float64), "vn 0.1 0.2 0.3333333333333333\n");
}

TEST_F(NormalsWriter, ObjWithoutNormalsIsWhatItWas) {
  EXPECT_EQ(obj(false, Precision::float32), plain_obj);
}

TEST_F(NormalsWriter, PlyHasThemAsProperties) {
  if (std::endian::native == std::endian::big) GTEST_SKIP() << "written for little-endian hosts";
  EXPECT_EQ(ply(true, Precision::float32), expected_ply<float>("float", true));
  EXPECT_EQ(ply(true, Precision::float64), expected_ply<double>("double", true));
}

TEST_F(NormalsWriter, PlyWithoutNormalsIsWhatItWas) {
  if (std::endian::native == std::endian::big) GTEST_SKIP() << "written for little-endian hosts";
  EXPECT_EQ(ply(false, Precision::float32), expected_ply<float>("float", false));
  EXPECT_EQ(ply(false, Precision::float64), expected_ply<double>("double", false));
}

TEST_F(NormalsWriter, BothReadBackAsTheSameMesh) {
  obj(true, Precision::float64);
  ply(true, Precision::float64);
  for (const char* name : {"a.obj", "a.ply"}) {
    const Mesh mesh = read_mesh(folder / name);
    ASSERT_EQ(mesh.positions.size(), 5u) << name;
    EXPECT_EQ(mesh.positions[0].y, 1.0 / 3) << name;
    EXPECT_EQ(mesh.positions[4].z, 10) << name;
    EXPECT_EQ(mesh.triangles, (std::vector<uint32_t>{0, 1, 2})) << name;
    EXPECT_TRUE(mesh.warnings.empty()) << name;
  }
}

}  // namespace
}  // namespace weft::io::test
