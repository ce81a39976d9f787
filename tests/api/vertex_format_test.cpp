// The packed formats, decoded by the rules of the graphics interfaces and compared with what went
// in: half floats, signed normalised integers, octahedral normals.
#include <cmath>
#include <cstring>

#include "reference/world_helpers.h"

namespace weft_tests {
namespace {

/// A half float by its definition.
double half(uint16_t bits) {
  const int exponent = bits >> 10 & 31, mantissa = bits & 1023;
  double v = exponent == 0    ? std::ldexp(mantissa, -24)
             : exponent == 31 ? (mantissa ? NAN : INFINITY)
                              : std::ldexp(1024 + mantissa, exponent - 25);
  return bits & 0x8000 ? -v : v;
}

/// A cloth of free points: a sheet whose vertices are put where the test wants them.
class Points {
 public:
  explicit Points(const std::vector<Vec>& at) {
    weft::GridDesc grid;
    grid.rows = 1;
    grid.columns = uint32_t(at.size());
    weft::ClothDesc cloth;
    const std::vector<weft::double3> x = to_weft(at);
    cloth.positions = weft::View<weft::double3>(x);
    weft::WorldDesc desc;
    desc.precision = weft::Precision::float64;
    test = std::make_unique<TestWorld>(desc);
    id = test->add(grid, cloth);
  }
  std::unique_ptr<TestWorld> test;
  weft::ClothId id;
};

TEST(HalfFloats, AreTheNearestOnesTiesToEven) {
  std::vector<Vec> at;
  const double values[] = {0,           1,           -1,      1.0 / 3, 65504,       65519,
                           65520,       -1e6,        6.1e-5,  5.9e-8,  2.9e-8,      3e-8,
                           0.1,         2048.5,      2049,    2051,    1 + 0x1p-11, 1 + 0x3p-11,
                           0x1p-14,     0x1.ffcp-15, 0x1p-24, 0x3p-25, 0x1p-25,     1234.567,
                           -0.00012345, 40000};
  for (const double v : values) at.push_back({v, -v, 0});
  Points points(at);
  std::vector<uint16_t> out(4 * at.size());
  weft::OutputDesc desc;
  desc.layout.position = {weft::Format::f16x4, 0, 8};
  desc.memory = out.data();
  points.test->take(points.test->world().bind_output(points.id, desc));
  points.test->check(points.test->world().write_outputs());
  for (size_t i = 0; i < at.size(); ++i) {
    const double v = float(at[i].x);
    // The nearest of all halves, found by trying them.
    double nearest = INFINITY, best = INFINITY;
    bool even = false;
    for (uint32_t bits = 0; bits < 0x7c00; ++bits) {
      const double h = half(uint16_t(bits)), away = std::abs(std::abs(v) - h);
      if (away < best || (away == best && bits % 2 == 0 && !even)) {
        best = away;
        nearest = h;
        even = bits % 2 == 0;
      }
    }
    if (std::abs(v) >= 65520) nearest = INFINITY;
    EXPECT_EQ(half(out[4 * i]), std::copysign(nearest, v)) << v;
    EXPECT_EQ(half(out[4 * i + 1]), std::copysign(nearest, -v)) << v;
    EXPECT_EQ(half(out[4 * i + 3]), 1.0);
  }
}

class PackedNormals : public testing::Test {
 protected:
  PackedNormals() {
    // A crumpled sheet: its normals point everywhere.
    weft::GridDesc grid;
    grid.rows = grid.columns = 40;
    std::vector<weft::double3> x;
    for (int v = 0; v < 1600; ++v) {
      const double a = v % 40 * 0.4, b = v / 40 * 0.4;
      x.push_back({std::sin(3 * b) + 0.3 * a, std::cos(2 * a + b), std::sin(a) + 0.3 * b});
    }
    weft::ClothDesc cloth;
    cloth.positions = weft::View<weft::double3>(x);
    id = test.add(grid, cloth);
    normals.resize(1600);
    test.check(test.world().read_normals(id, normals.data()));
  }
  template <class Element>
  std::vector<Element> packed(weft::Format format) {
    std::vector<Element> out(1600 * weft::size_of(format) / sizeof(Element));
    weft::OutputDesc desc;
    desc.layout.normal = {format, 0, weft::size_of(format)};
    desc.memory = out.data();
    const weft::OutputId output = test.take(test.world().bind_output(id, desc));
    test.check(test.world().write_outputs());
    test.check(test.world().unbind_output(output));
    return out;
  }
  TestWorld test;
  weft::ClothId id;
  std::vector<weft::double3> normals;
};

TEST_F(PackedNormals, SignedNormalisedIntegersAreWithinHalfAStep) {
  const std::vector<int8_t> small = packed<int8_t>(weft::Format::snorm8x4);
  const std::vector<int16_t> large = packed<int16_t>(weft::Format::snorm16x4);
  for (size_t v = 0; v < 1600; ++v) {
    const double n[3] = {normals[v].x, normals[v].y, normals[v].z};
    for (size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(small[4 * v + c], 127 * n[c], 0.5001);
      EXPECT_NEAR(large[4 * v + c], 32767 * n[c], 0.51);
    }
    EXPECT_EQ(small[4 * v + 3], 0);
    EXPECT_EQ(large[4 * v + 3], 0);
  }
}

TEST_F(PackedNormals, OctahedralNormalsDecodeToTheSameDirection) {
  const std::vector<int16_t> out = packed<int16_t>(weft::Format::oct16x2);
  int below = 0;
  for (size_t v = 0; v < 1600; ++v) {
    const double a = out[2 * v] / 32767.0, b = out[2 * v + 1] / 32767.0;
    Vec n{a, b, 1 - std::abs(a) - std::abs(b)};
    if (n.z < 0) {
      ++below;
      n.x = (1 - std::abs(b)) * (a < 0 ? -1 : 1);
      n.y = (1 - std::abs(a)) * (b < 0 ? -1 : 1);
    }
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    EXPECT_NEAR(n.x / length, normals[v].x, 1e-4) << v;
    EXPECT_NEAR(n.y / length, normals[v].y, 1e-4) << v;
    EXPECT_NEAR(n.z / length, normals[v].z, 1e-4) << v;
  }
  EXPECT_GT(below, 100);
}

}  // namespace
}  // namespace weft_tests
