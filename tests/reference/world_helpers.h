// One context and one world for a test, with the text of the log: a call that should succeed and
// does not ends the test with that text.
#pragma once

#include "reference/vec.h"

#include "weft/weft.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace weft {
inline namespace v0 {
// How GoogleTest prints parameters.
inline void PrintTo(Precision p, std::ostream* out) { *out << to_string(p); }
inline void PrintTo(Status s, std::ostream* out) { *out << to_string(s); }
}  // namespace v0
}  // namespace weft

namespace weft_tests {

using reference::Vec;

inline weft::double3 to_weft(Vec v) { return {v.x, v.y, v.z}; }
inline Vec from_weft(weft::double3 v) { return {v.x, v.y, v.z}; }
inline std::vector<weft::double3> to_weft(const std::vector<Vec>& points) {
  std::vector<weft::double3> out;
  for (Vec p : points) out.push_back(to_weft(p));
  return out;
}
inline std::vector<Vec> from_weft(const std::vector<weft::double3>& points) {
  std::vector<Vec> out;
  for (weft::double3 p : points) out.push_back(from_weft(p));
  return out;
}

/// The tolerance of an exact discrete solution of size `size`: 1e-10 m in float64, relative 2e-5 in
/// float32.
inline double tolerance(weft::Precision precision, double size) {
  return precision == weft::Precision::float64 ? 1e-10 : 2e-5 * std::abs(size);
}

/// A world with one substep per step and without gravity unless a test asks for more.
inline weft::WorldDesc plain_world(weft::Precision precision,
                                   weft::Start start = weft::Start::taylor) {
  weft::WorldDesc desc;
  desc.gravity = {0, 0, 0};
  desc.precision = precision;
  desc.start = start;
  desc.substeps = 1;
  return desc;
}

/// The host's, unless the environment names another: WEFT_TEST_BACKEND=cuda runs the tests of
/// worlds on the GPU.
inline weft::BackendKind tested_backend() {
  const char* name = std::getenv("WEFT_TEST_BACKEND");
  if (!name || std::strcmp(name, "omp") == 0) return weft::BackendKind::omp;
  if (std::strcmp(name, "cuda") == 0) return weft::BackendKind::cuda;
  if (std::strcmp(name, "hip") == 0) return weft::BackendKind::hip;
  throw std::runtime_error(std::string("WEFT_TEST_BACKEND: ") + name +
                           " is not a back end (give omp, cuda or hip)");
}

inline bool on_host() { return tested_backend() == weft::BackendKind::omp; }

class TestWorld {
 public:
  explicit TestWorld(const weft::WorldDesc& desc = {}, weft::ContextDesc context = one_thread()) {
    context.log = {&log_, &TestWorld::append};
    context_ = take(weft::Context::create(context));
    world_ = take(context_.create_world(desc));
  }
  TestWorld(const TestWorld&) = delete;
  TestWorld& operator=(const TestWorld&) = delete;

  static weft::ContextDesc one_thread() {
    weft::ContextDesc desc;
    desc.backend = tested_backend();
    desc.threads = 1;
    return desc;
  }

  weft::Context& context() { return context_; }
  weft::World& world() { return world_; }
  const std::string& log() const { return log_; }
  void clear_log() { log_.clear(); }

  /// A Fabric, or a ColliderMesh.
  template <class Desc>
  auto cook(const Desc& desc) {
    return take(context_.cook(desc));
  }
  weft::ClothId add(const weft::ClothDesc& desc) { return take(world_.create_cloth(desc)); }
  /// Cooks `fabric` and makes a cloth of it as `desc` says.
  template <class Desc>
  weft::ClothId add(const Desc& fabric, weft::ClothDesc desc) {
    desc.fabric = cook(fabric);
    vertices_ = desc.fabric.vertex_count();
    return add(desc);
  }

  void step(double dt, int count = 1) {
    for (int i = 0; i < count; ++i) check(world_.step(dt));
  }

  /// Of the cloth that add(fabric, desc) made last, or of one with `count` vertices.
  std::vector<Vec> positions(weft::ClothId cloth, uint32_t count = 0) {
    std::vector<weft::double3> out(count ? count : vertices_);
    check(world_.read_positions(cloth, out.data()));
    return from_weft(out);
  }
  std::vector<Vec> velocities(weft::ClothId cloth, uint32_t count = 0) {
    std::vector<weft::double3> out(count ? count : vertices_);
    check(world_.read_velocities(cloth, out.data()));
    return from_weft(out);
  }
  std::vector<Vec> accelerations(weft::ClothId cloth, uint32_t count = 0) {
    std::vector<weft::double3> out(count ? count : vertices_);
    check(world_.read_accelerations(cloth, out.data()));
    return from_weft(out);
  }
  Vec position(weft::ClothId cloth, uint32_t vertex) { return positions(cloth).at(vertex); }
  uint64_t hash() { return take(world_.state_hash()); }
  weft::Mechanics mechanics() { return take(world_.mechanics()); }

  template <class T>
  T take(weft::Result<T> result) {
    check(result.status());
    return static_cast<T&&>(*result);
  }
  void check(weft::Status status) {
    if (status != weft::Status::ok)
      throw std::runtime_error(std::string(weft::to_string(status)) + ": " + log_);
  }

 private:
  static void append(void* user, weft::Severity, const char* text) {
    *static_cast<std::string*>(user) += std::string(text) + "\n";
  }

  std::string log_;
  weft::Context context_;
  weft::World world_;
  uint32_t vertices_ = 0;
};

inline bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
inline bool same_bits(Vec a, Vec b) { return std::memcmp(&a, &b, sizeof a) == 0; }
inline bool all_finite(const std::vector<Vec>& points) {
  for (Vec p : points)
    if (!reference::finite(p)) return false;
  return true;
}

inline void expect_near(Vec actual, Vec expected, double within) {
  EXPECT_NEAR(actual.x, expected.x, within);
  EXPECT_NEAR(actual.y, expected.y, within);
  EXPECT_NEAR(actual.z, expected.z, within);
}

/// Tests that run in both precisions.
class BothPrecisions : public testing::TestWithParam<weft::Precision> {};
inline auto both_precisions() {
  return testing::Values(weft::Precision::float32, weft::Precision::float64);
}
inline std::string precision_name(const testing::TestParamInfo<weft::Precision>& info) {
  return weft::to_string(info.param);
}

}  // namespace weft_tests
