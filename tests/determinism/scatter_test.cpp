// Gather and scatter give the same bits; so do integer sums, on any number of threads.
#include "determinism/levels.h"
#include "determinism/scenes.h"

namespace weft_tests {
namespace {

uint64_t hash_of(Scene scene, Variant variant, weft::Evaluation evaluation,
                 weft::Accumulate accumulate, uint32_t threads,
                 weft::Isa isa = weft::Isa::automatic) {
  weft::WorldDesc desc = scene_world(variant);
  desc.evaluation = evaluation;
  desc.accumulate = accumulate;
  weft::ContextDesc context = TestWorld::one_thread();
  context.threads = threads;
  context.isa = isa;
  TestWorld test(desc, context);
  add_scene(test, scene);
  test.step(1.0 / 60, 4);
  return test.hash();
}

class Scatter : public testing::TestWithParam<std::tuple<Scene, weft::Precision, weft::Form>> {
 protected:
  const Scene scene = std::get<0>(GetParam());
  const Variant variant{std::get<1>(GetParam()), std::get<2>(GetParam())};
};

TEST_P(Scatter, NativeHasTheBitsOfTheGather) {
  const uint64_t gather =
      hash_of(scene, variant, weft::Evaluation::gather, weft::Accumulate::native, 1);
  for (uint32_t threads : {1u, 2u, 5u}) {
    EXPECT_EQ(hash_of(scene, variant, weft::Evaluation::scatter, weft::Accumulate::native, threads),
              gather)
        << threads;
  }
  EXPECT_EQ(hash_of(scene, variant, weft::Evaluation::automatic, weft::Accumulate::native, 2),
            gather);
}

TEST_P(Scatter, SumsThatDoNotMindTheOrderAreTheSameOnAllThreadsAndInAllRuns) {
  const weft::Accumulate modes[] = {weft::Accumulate::fixed64, weft::Accumulate::float16,
                                    weft::Accumulate::float24, weft::Accumulate::float24_all,
                                    weft::Accumulate::fixed8};
  for (weft::Accumulate mode : modes) {
    const uint64_t one = hash_of(scene, variant, weft::Evaluation::scatter, mode, 1);
    for (uint32_t threads : {2u, 5u, 2u}) {
      EXPECT_EQ(hash_of(scene, variant, weft::Evaluation::scatter, mode, threads), one)
          << weft::to_string(mode) << " " << threads;
    }
  }
}

TEST_P(Scatter, BitsDoNotDependOnTheInstructionSet) {
  if (!on_host()) GTEST_SKIP() << "of the host back end";
  if (levels().size() < 2) GTEST_SKIP() << "there is one level";
  for (weft::Accumulate mode : {weft::Accumulate::native, weft::Accumulate::fixed64,
                                weft::Accumulate::float16, weft::Accumulate::fixed8}) {
    const auto hash_at = [&](weft::Isa isa) {
      return hash_of(scene, variant, weft::Evaluation::scatter, mode, 2, isa);
    };
    const uint64_t first = hash_at(levels().front());
    for (weft::Isa isa : levels()) {
      if (isa == levels().front()) continue;
      EXPECT_EQ(hash_at(isa), first) << weft::to_string(mode) << " " << name(isa);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Scatter,
                         testing::Combine(testing::ValuesIn(all_scenes), both_precisions(),
                                          testing::Values(weft::Form::summed,
                                                          weft::Form::position)),
                         [](const auto& info) {
                           return std::string(name(std::get<0>(info.param))) + "_" +
                                  weft::to_string(std::get<1>(info.param)) +
                                  (std::get<2>(info.param) == weft::Form::summed ? "_summed"
                                                                                 : "_position");
                         });

}  // namespace
}  // namespace weft_tests
