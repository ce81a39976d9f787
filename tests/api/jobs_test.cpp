// With the caller's jobs weft opens no OpenMP region: this program counts them, by standing in for
// the entry point of g++'s runtime.
#include <dlfcn.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "reference/world_helpers.h"

static std::atomic<int> regions{0};

extern "C" {
void GOMP_parallel(void (*body)(void*), void* data, unsigned threads, unsigned flags);
void GOMP_parallel(void (*body)(void*), void* data, unsigned threads, unsigned flags) {
  ++regions;
  using Entry = void (*)(void (*)(void*), void*, unsigned, unsigned);
  static const Entry real = reinterpret_cast<Entry>(dlsym(RTLD_NEXT, "GOMP_parallel"));
  real(body, data, threads, flags);
}
}

namespace weft_tests {
namespace {

/// Two workers of the caller's, and a record of what they were asked.
struct Pool {
  static void parallel_for(void* user, uint32_t count, uint32_t grain,
                           void (*fn)(void*, uint32_t, uint32_t), void* context, const char* name) {
    auto& pool = *static_cast<Pool*>(user);
    ++pool.calls;
    if (grain == 0 || !name) ++pool.wrong;
    // Odd ranges, the last first, on two threads.
    const uint32_t middle = count / 3;
    std::thread other([&] { fn(context, middle, count); });
    for (uint32_t begin = 0; begin < middle; begin += grain) {
      fn(context, begin, std::min(begin + grain, middle));
    }
    other.join();
  }
  static void launch(void* user, void (*fn)(void*), void* context, const char*) {
    auto& pool = *static_cast<Pool*>(user);
    ++pool.launches;
    const std::lock_guard lock(pool.mutex);
    pool.threads.emplace_back(fn, context);
  }
  weft::Jobs jobs(bool with_launch) {
    weft::Jobs made;
    made.user = this;
    made.workers = 2;
    made.parallel_for = parallel_for;
    if (with_launch) made.launch = launch;
    return made;
  }
  ~Pool() {
    for (std::thread& t : threads) t.join();
  }
  std::atomic<int> calls{0}, wrong{0}, launches{0};
  std::mutex mutex;
  std::vector<std::thread> threads;
};

void add_cloths(TestWorld& test) {
  weft::GridDesc grid;
  grid.rows = grid.columns = 48;
  const weft::Pin pins[] = {{0}, {47}};
  weft::ClothDesc cloth;
  cloth.pins = {pins, 2};
  test.add(grid, cloth);
  weft::SphereDesc sphere;
  sphere.center = {0.5, -0.2, 0.1};
  sphere.radius = 0.3;
  test.take(test.world().create_sphere(sphere));
  test.check(test.world().set_wind({}));
}

TEST(JobSystem, DoesAllTheWorkWithTheSameBits) {
  Pool pool;
  weft::ContextDesc desc;
  desc.backend = weft::BackendKind::omp;
  desc.jobs = pool.jobs(false);
  TestWorld own({}, TestWorld::one_thread()), test({}, desc);
  add_cloths(own);
  add_cloths(test);
  own.step(1.0 / 60, 20);
  const int before = regions;
  test.step(1.0 / 60, 20);
  EXPECT_EQ(test.hash(), own.hash());
  (void)test.mechanics();
  EXPECT_EQ(regions, before);
  EXPECT_GT(pool.calls, 20);
  EXPECT_EQ(pool.wrong, 0);
  EXPECT_EQ(test.context().info().threads, 2u);
}

TEST(JobSystem, RunsAStepInFlightWhereItCanLaunch) {
  for (const bool with_launch : {false, true}) {
    Pool pool;
    weft::ContextDesc desc;
    desc.backend = weft::BackendKind::omp;
    desc.jobs = pool.jobs(with_launch);
    TestWorld own, test({}, desc);
    add_cloths(own);
    add_cloths(test);
    own.step(1.0 / 60, 3);
    const int before = regions;
    for (int i = 0; i < 3; ++i) {
      test.check(test.world().begin_step(1.0 / 60));
      if (!with_launch) {
        EXPECT_TRUE(test.world().step_done());
      }
      test.check(test.world().end_step());
    }
    EXPECT_EQ(regions, before);
    EXPECT_EQ(test.hash(), own.hash());
    EXPECT_EQ(pool.launches, with_launch ? 3 : 0);
  }
}

TEST(JobSystem, RegionsAreCountedAtAll) {
#if defined(__clang__)
  GTEST_SKIP() << "clang's runtime has other entry points";
#endif
  weft::ContextDesc desc = TestWorld::one_thread();
  desc.threads = 2;
  TestWorld test({}, desc);
  if (!on_host()) GTEST_SKIP() << "a GPU opens no region";
  weft::GridDesc grid;
  grid.rows = grid.columns = 48;
  test.add(grid, {});
  const int before = regions;
  test.step(1.0 / 60, 5);
  EXPECT_EQ(regions, before + 5 + 2);  // a region per step; at first one for the start, one to look
}

TEST(JobSystem, HalfOfItIsRefused) {
  weft::ContextDesc desc;
  Pool pool;
  desc.jobs = pool.jobs(true);
  desc.jobs.workers = 0;
  EXPECT_EQ(weft::Context::create(desc).status(), weft::Status::invalid_argument);
  desc.jobs = {};
  desc.jobs.workers = 2;
  EXPECT_EQ(weft::Context::create(desc).status(), weft::Status::invalid_argument);
  desc.jobs = {};
  desc.jobs.launch = Pool::launch;
  EXPECT_EQ(weft::Context::create(desc).status(), weft::Status::invalid_argument);
  desc.jobs = pool.jobs(true);
  desc.jobs.workers = 1025;
  EXPECT_EQ(weft::Context::create(desc).status(), weft::Status::invalid_argument);
}

}  // namespace
}  // namespace weft_tests
