// One scene, one hash: for every number of threads, instruction set and run (HC75).
#include "determinism/levels.h"
#include "determinism/scenes.h"

#include <algorithm>
#include <bit>

namespace weft_tests {
namespace {

struct Outcome {
  uint64_t hash;
  weft::Mechanics mechanics;
};

Outcome outcome(Scene scene, Variant variant, weft::ContextDesc context) {
  context.backend = weft::BackendKind::omp;
  TestWorld test(scene_world(variant), context);
  add_scene(test, scene);
  run_scene(test);
  return {test.hash(), test.mechanics()};
}

void expect_same(const Outcome& a, const Outcome& b) {
  EXPECT_EQ(a.hash, b.hash);
  EXPECT_TRUE(same_bits(a.mechanics.kinetic, b.mechanics.kinetic));
  EXPECT_TRUE(same_bits(a.mechanics.elastic, b.mechanics.elastic));
  EXPECT_TRUE(same_bits(a.mechanics.potential, b.mechanics.potential));
  EXPECT_TRUE(same_bits(from_weft(a.mechanics.momentum), from_weft(b.mechanics.momentum)));
}

class Bits : public testing::TestWithParam<std::tuple<Scene, weft::Precision, weft::Form>> {
 protected:
  const Scene scene = std::get<0>(GetParam());
  const Variant variant{std::get<1>(GetParam()), std::get<2>(GetParam())};
};

TEST_P(Bits, DoNotDependOnTheNumberOfThreads) {
  weft::ContextDesc context;
  context.threads = 1;
  const Outcome one = outcome(scene, variant, context);
  for (uint32_t threads : {2u, 3u, 5u, 8u}) {
    SCOPED_TRACE(threads);
    context.threads = threads;
    expect_same(outcome(scene, variant, context), one);
  }
}

TEST_P(Bits, DoNotDependOnTheInstructionSet) {
  if (levels().size() < 2) GTEST_SKIP() << "there is one level";
  weft::ContextDesc context;
  context.threads = 2;
  const Outcome automatic = outcome(scene, variant, context);
  for (weft::Isa isa : levels()) {
    SCOPED_TRACE(name(isa));
    context.isa = isa;
    expect_same(outcome(scene, variant, context), automatic);
  }
}

TEST_P(Bits, AreTheSameInTenRuns) {
  weft::ContextDesc context;
  context.threads = 2;
  const Outcome first = outcome(scene, variant, context);
  for (int run = 1; run < 10; ++run) {
    SCOPED_TRACE(run);
    expect_same(outcome(scene, variant, context), first);
  }
}

std::string bits_name(const testing::TestParamInfo<Bits::ParamType>& info) {
  const auto& [scene, precision, form] = info.param;
  return std::string(name(scene)) + "_" + weft::to_string(precision) +
         (form == weft::Form::summed ? "_summed" : "_position");
}
INSTANTIATE_TEST_SUITE_P(Scenes, Bits,
                         testing::Combine(testing::ValuesIn(all_scenes), both_precisions(),
                                          testing::Values(weft::Form::summed,
                                                          weft::Form::position)),
                         bits_name);

TEST(Scenes, MeetTheirColliders) {
  for (Scene scene : all_scenes) {
    TestWorld with(scene_world({})), without(scene_world({}));
    add_scene(with, scene);
    add_cloths(without, scene);
    run_scene(with);
    run_scene(without);
    EXPECT_NE(with.hash(), without.hash()) << name(scene);
    EXPECT_GT(with.world().stats().particles, 1000u);
  }
}

TEST(Hash, AnInstructionSetThatIsNamedIsUsed) {
  if (!on_host()) GTEST_SKIP() << "of the host back end";
  EXPECT_FALSE(levels().empty());
  for (weft::Isa isa : levels()) {
    weft::ContextDesc context = TestWorld::one_thread();
    context.isa = isa;
    TestWorld test({}, context);
    EXPECT_STREQ(test.context().info().isa, name(isa));
  }
}

TEST(Hash, ThreadsAreHonouredAboveTheNumberOfCores) {
  weft::ContextDesc context = TestWorld::one_thread();
  context.threads = 8;
  TestWorld test(scene_world({}), context);
  EXPECT_EQ(test.context().info().threads, 8u);
  add_scene(test, Scene::mixed);
  test.step(0.01, 2);
  EXPECT_EQ(test.world().stats().threads, 8u);
}

TEST(Hash, SeesEverySingleBit) {
  uint64_t hashes[3];
  const double xs[] = {1, std::nextafter(1.0, 2.0), double(std::nextafter(1.0f, 2.0f))};
  for (int i = 0; i < 3; ++i) {
    TestWorld test(plain_world(weft::Precision::float64));
    add_particles(test, {{0, 0, 0}, {0, xs[i], 0}});
    hashes[i] = test.hash();
  }
  EXPECT_NE(hashes[0], hashes[1]);
  EXPECT_NE(hashes[0], hashes[2]);
}

/// FNV-1a 64 over the little-endian bytes of `value`.
template <class Word, class T>
void add_bytes(uint64_t& hash, T value) {
  const Word word = std::bit_cast<Word>(value);
  for (size_t byte = 0; byte < sizeof word; ++byte) {
    hash ^= (word >> (8 * byte)) & 0xff;
    hash *= 0x100000001b3u;
  }
}

TEST(Hash, IsFnvOfAllWorldPositionsInTheOrderOfCreation) {
  for (weft::Precision precision : {weft::Precision::float32, weft::Precision::float64}) {
    weft::WorldDesc desc;
    desc.precision = precision;
    TestWorld test(desc);
    Sheet sheet;
    sheet.noise = 0.01;
    weft::ClothDesc far;
    far.velocity = {0.5, 1, 0};
    const weft::ClothId first = sheet.add_to(test);
    const weft::ClothId gone = sheet.add_to(test);
    const weft::ClothId second = sheet.add_network_to(test, far);
    test.step(0.01, 4);
    test.check(test.world().destroy_cloth(gone));
    const weft::ClothId third = sheet.add_to(test);  // last, whatever slot it takes
    uint64_t hash = 0xcbf29ce484222325u;
    for (weft::ClothId cloth : {first, second, third})
      for (Vec x : test.positions(cloth))
        for (double c : {x.x, x.y, x.z}) {
          if (precision == weft::Precision::float32)
            add_bytes<uint32_t>(hash, float(c));
          else
            add_bytes<uint64_t>(hash, c);
        }
    EXPECT_EQ(test.hash(), hash) << weft::to_string(precision);
  }
}

}  // namespace
}  // namespace weft_tests
