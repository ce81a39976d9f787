// A step whose work is smaller than a parallel region costs does not open one.
#include "reference/networks.h"

#include <chrono>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#  define WEFT_TESTS_SANITIZED 1
#elif defined(__has_feature)
#  if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#    define WEFT_TESTS_SANITIZED 1
#  endif
#endif

namespace weft_tests {
namespace {

#if defined(WEFT_TESTS_SANITIZED) || !defined(NDEBUG)
constexpr bool timed = false;
#else
constexpr bool timed = true;
#endif

/// Least of three measurements, s.
template <class Run>
double seconds(Run run) {
  double least = 1e9;
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    run();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    least = std::min(least, taken.count());
  }
  return least;
}

class SingleParticle : public testing::TestWithParam<uint32_t> {
 protected:
  void SetUp() override {
    if (!timed) GTEST_SKIP() << "timed in Release without sanitizers only";
    if (!on_host()) GTEST_SKIP() << "a launch takes microseconds; weft bench gpu tells how many";
  }
  weft::ContextDesc context() const {
    weft::ContextDesc desc = TestWorld::one_thread();
    desc.threads = GetParam();
    return desc;
  }
};

TEST_P(SingleParticle, SixtyThousandSubstepsTakeLessThanAFifthOfASecond) {
  weft::WorldDesc desc;
  desc.substeps = 60000;
  TestWorld test(desc, context());
  add_particles(test, {{0, 0, 0}});
  test.step(1);
  EXPECT_LT(seconds([&] { test.step(1); }), 0.2);
}

TEST_P(SingleParticle, SixtyThousandStepsTakeLessThanAFifthOfASecond) {
  weft::WorldDesc desc;
  desc.substeps = 1;
  TestWorld test(desc, context());
  add_particles(test, {{0, 0, 0}});
  test.step(1e-4);
  EXPECT_LT(seconds([&] { test.step(1e-4, 60000); }), 0.2);
}

INSTANTIATE_TEST_SUITE_P(Threads, SingleParticle, testing::Values(0u, 1u, 2u, 8u));

}  // namespace
}  // namespace weft_tests
