#include "io/point_cache.h"

#include "support.h"

#include <bit>
#include <cstring>
#include <limits>
#include <random>

namespace weft::io::test {
namespace {

/// A header and a body by the format's page, written by hand.
std::string file_of(int32_t points, int32_t samples, size_t floats, int32_t version = 1,
                    float start = 0, float rate = 1) {
  std::string bytes("POINTCACHE2\0", 12);
  const auto put = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(version);
  put(points);
  put(start);
  put(rate);
  put(samples);
  for (size_t i = 0; i < floats; ++i) put(float(i) / 3);
  return bytes;
}

std::string refusal(const std::string& bytes) {
  return input_error([&] { read_point_cache(bytes, "a.pc2"); });
}

TEST(PointCache, WritesTheHeaderOfTheFormat) {
  const TemporaryFolder folder;
  PointCacheWriter writer(folder / "a.pc2", 2, 3, 0.5f);
  const double3 points[2] = {{0, 1.0 / 3, 2.0 / 3}, {1, 4.0 / 3, 5.0 / 3}};
  writer.add(points);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.pc2")) << "nothing before commit";
  writer.commit();
  EXPECT_EQ(read_text(folder / "a.pc2"), file_of(2, 1, 6, 1, 3, 0.5f));
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(PointCache, KeepsEveryBitOfAFloat) {
  const TemporaryFolder folder;
  std::mt19937 random(7);
  std::vector<double3> points(50);
  PointCacheWriter writer(folder / "a.pc2", points.size());
  std::vector<float> written;
  for (int sample = 0; sample < 20; ++sample) {
    for (double3& p : points) {
      for (double* value : {&p.x, &p.y, &p.z}) {
        float any = std::bit_cast<float>(uint32_t(random()));
        if (!std::isfinite(any)) any = -0.0f;
        *value = any;
        written.push_back(any);
      }
    }
    writer.add(points.data());
  }
  writer.commit();
  const PointCache cache = read_point_cache(folder / "a.pc2");
  EXPECT_EQ(cache.points, 50u);
  EXPECT_EQ(cache.samples, 20u);
  ASSERT_EQ(cache.positions.size() * 3, written.size());
  EXPECT_EQ(std::memcmp(cache.positions.data(), written.data(), written.size() * sizeof(float)), 0);
}

TEST(PointCache, HoldsNothingWithoutSamplesOrPoints) {
  EXPECT_TRUE(read_point_cache(file_of(5, 0, 0), "a").positions.empty());
  EXPECT_TRUE(read_point_cache(file_of(0, 5, 0), "a").positions.empty());
}

TEST(PointCache, RefusesWhatIsNotOne) {
  EXPECT_CONTAINS(refusal(""), "a.pc2: does not start with 'POINTCACHE2'");
  EXPECT_CONTAINS(refusal("POINTCACHE2"), "does not start");
  EXPECT_CONTAINS(refusal(file_of(1, 1, 3).substr(0, 31)),
                  "has 31 bytes (the header alone has 32)");
  EXPECT_CONTAINS(refusal(file_of(1, 1, 3, 2)), "has version 2");
  EXPECT_CONTAINS(refusal(file_of(-1, 1, 3)), "the number of points, -1, is negative");
  EXPECT_CONTAINS(refusal(file_of(1, INT32_MIN, 3)), "the number of samples, -2147483648");
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_CONTAINS(refusal(file_of(1, 1, 3, 1, infinity)), "the first frame, inf, is not finite");
  for (const float rate : {0.0f, -1.0f, infinity, std::nanf("")}) {
    EXPECT_CONTAINS(refusal(file_of(1, 1, 3, 1, 0, rate)), "the sample rate, ");
  }
}

TEST(PointCache, TakesNoMemoryForWhatIsNotThere) {
  EXPECT_CONTAINS(refusal(file_of(INT32_MAX, INT32_MAX, 3)), "has 12 bytes behind the header");
  EXPECT_CONTAINS(refusal(file_of(1 << 30, 4, 0)), "4 samples of 1073741824 points");
  EXPECT_CONTAINS(refusal(file_of(2, 2, 11)), "has 44 bytes");
  EXPECT_CONTAINS(refusal(file_of(2, 2, 13)), "has 52 bytes");
  EXPECT_CONTAINS(refusal(file_of(1, 1, 3) + "x"), "has 13 bytes");
}

TEST(PointCache, RefusesPointsThatAreNotFinite) {
  for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    for (size_t number = 0; number < 12; ++number) {
      std::string bytes = file_of(2, 2, 12);
      std::memcpy(bytes.data() + 32 + 4 * number, &bad, 4);
      EXPECT_CONTAINS(refusal(bytes), "sample " + std::to_string(number / 6) + ", point " +
                                          std::to_string(number / 3 % 2) + " is not finite");
    }
  }
}

TEST(PointCache, FailsWithoutATrace) {
  const TemporaryFolder folder;
  EXPECT_THROW(PointCacheWriter(folder / "no/a.pc2", 1), OutputError);
  EXPECT_THROW(PointCacheWriter(folder / "a.pc2", size_t(1) << 31), OutputError);
  EXPECT_EQ(folder.file_count(), 0u);
  PointCacheWriter full("/dev/full", 1);
  const double3 point{1, 2, 3};
  full.add(&point);
  EXPECT_THROW(full.commit(), OutputError);
}

}  // namespace
}  // namespace weft::io::test
