// What is written can be read back, to the last digit that the format holds.
#include "io/csv_writer.h"
#include "io/mesh.h"
#include "io/surface.h"

#include "support.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>

namespace weft::io::test {
namespace {

/// Any bits that are a finite number: denormals, both zeros, the largest.
template <class Bits, class Real>
double any_number(std::mt19937_64& random) {
  const Real value = std::bit_cast<Real>(Bits(random()));
  return std::isfinite(value) ? double(value) : -0.0;
}

double3 any_point(std::mt19937_64& random, Precision precision) {
  const auto next = [&] {
    return precision == Precision::float32 ? any_number<uint32_t, float>(random)
                                           : any_number<uint64_t, double>(random);
  };
  const double x = next(), y = next();
  return {x, y, next()};
}

Surface any_surface(Precision precision) {
  std::mt19937_64 random(11);
  Surface surface;
  for (int i = 0; i < 3000; ++i) {
    surface.positions.push_back(any_point(random, precision));
    surface.normals.push_back(any_point(random, precision));
  }
  for (uint32_t i = 0; i < 1000; ++i) {
    surface.triangles.push_back({i, (i + 1 + uint32_t(random() % 500)), 2999 - i});
  }
  // Names that a line would not end with, or end in the middle.
  surface.parts = {{"a\\", 0, 1000, 0, 400, 0, 0}, {"b\r\nv 1", 1000, 2000, 400, 600, 0, 0}};
  return surface;
}

void expect_same_bits(const std::vector<double3>& got, const std::vector<double3>& want) {
  ASSERT_EQ(got.size(), want.size());
  for (size_t i = 0; i < want.size(); ++i) {
    EXPECT_EQ(std::memcmp(&got[i], &want[i], sizeof(double3)), 0) << i;
  }
}

/// Through memory: g++ 12 drops the round trip of two neighbouring numbers at -O2.
double rounded(double v) {
  const volatile float narrow = float(v);
  return double(narrow);
}
double3 rounded(double3 p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

/// Text of a float has the digits that tell it from other floats, no more: it reads back as a
/// double that rounds to it.
void expect_equal(Mesh mesh, const Surface& surface, bool single) {
  EXPECT_TRUE(mesh.warnings.empty());
  if (single) {
    for (double3& p : mesh.positions) p = rounded(p);
  }
  expect_same_bits(mesh.positions, surface.positions);
  ASSERT_EQ(mesh.triangles.size(), 3 * surface.triangles.size());
  EXPECT_EQ(std::memcmp(mesh.triangles.data(), surface.triangles.data(),
                        mesh.triangles.size() * sizeof(uint32_t)),
            0);
}

TEST(RoundTrip, ObjAndPlyKeepAllBits) {
  const TemporaryFolder folder;
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    for (const bool normals : {false, true}) {
      const Surface surface = any_surface(precision);
      const bool single = precision == Precision::float32;
      write_obj(folder / "a.obj", surface, precision, normals);
      expect_equal(read_mesh(folder / "a.obj"), surface, single);
      write_ply(folder / "a.ply", surface, precision, normals);
      expect_equal(read_mesh(folder / "a.ply"), surface, false);
    }
  }
}

/// A decoder of what the writers add for normals, which the readers skip.
TEST(RoundTrip, NormalsOfObjKeepAllBits) {
  const TemporaryFolder folder;
  const Surface surface = any_surface(Precision::float64);
  write_obj(folder / "a.obj", surface, Precision::float64);
  std::istringstream lines(read_text(folder / "a.obj"));
  std::vector<double3> normals;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("vn ", 0) != 0) continue;
    char* at = line.data() + 3;
    const double x = std::strtod(at, &at), y = std::strtod(at, &at);
    normals.push_back({x, y, std::strtod(at, &at)});
  }
  expect_same_bits(normals, surface.normals);
}

TEST(RoundTrip, NormalsOfPlyKeepAllBits) {
  const TemporaryFolder folder;
  const Surface surface = any_surface(Precision::float64);
  write_ply(folder / "a.ply", surface, Precision::float64);
  const std::string text = read_text(folder / "a.ply");
  const char* body = text.data() + text.find("end_header\n") + 11;
  std::vector<double3> normals(surface.normals.size());
  for (size_t i = 0; i < normals.size(); ++i) {
    std::memcpy(&normals[i], body + 48 * i + 24, 24);
  }
  expect_same_bits(normals, surface.normals);
}

TEST(RoundTrip, FinalStateKeepsAllBits) {
  const TemporaryFolder folder;
  std::mt19937_64 random(3);
  std::vector<double3> positions, velocities;
  for (int i = 0; i < 2000; ++i) {
    positions.push_back(any_point(random, Precision::float64));
    velocities.push_back(any_point(random, Precision::float64));
  }
  FinalWriter writer(folder / "f.csv");
  writer.add_cloth(0, positions, velocities);
  writer.commit();
  std::istringstream lines(read_text(folder / "f.csv"));
  std::string line;
  std::getline(lines, line);
  std::vector<double3> read_positions, read_velocities;
  while (std::getline(lines, line)) {
    double values[8] = {};
    char* at = line.data();
    for (double& value : values) {
      value = std::strtod(at, &at);
      if (*at == ',') ++at;
    }
    EXPECT_EQ(*at, '\0') << line;
    EXPECT_EQ(values[1], double(read_positions.size()));
    read_positions.push_back({values[2], values[3], values[4]});
    read_velocities.push_back({values[5], values[6], values[7]});
  }
  expect_same_bits(read_positions, positions);
  expect_same_bits(read_velocities, velocities);
}

}  // namespace
}  // namespace weft::io::test
