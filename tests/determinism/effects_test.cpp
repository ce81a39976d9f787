// Every row of the table of effects: its bits are those of every build, of any number of threads
// and of any level, and not those of the cloths without it.
#include "determinism/golden_hashes.h"
#include "determinism/levels.h"
#include "reference/effect_world.h"

#include <cinttypes>
#include <cstdio>
#include <string_view>

namespace weft_tests {
namespace {

constexpr Variant variants[] = {{weft::Precision::float32, weft::Form::summed},
                                {weft::Precision::float32, weft::Form::position},
                                {weft::Precision::float64, weft::Form::summed},
                                {weft::Precision::float64, weft::Form::position}};

uint64_t hash_of(const Changes& changes, Variant variant, const weft::ContextDesc& desc) {
  weft::Context context = weft::samples::take(weft::Context::create(desc));
  EffectWorld made(context, scene_world(variant), changes);
  made.step(12);
  return made.hash();
}
std::string text_of(Variant v) {
  return std::string(weft::to_string(v.precision)) +
         (v.form == weft::Form::summed ? " summed" : " position");
}

EffectHashes golden_of(const Effect& effect) {
  for (const EffectHashes& golden : effect_hashes) {
    if (std::string_view(effect.name) == golden.effect) return golden;
  }
  return {};
}

class EffectBits : public testing::TestWithParam<size_t> {
 protected:
  const Effect& effect = weft::samples::effects[GetParam()];
  const Changes used{&effect.needs, &effect.used}, unused{&effect.needs};
};

TEST_P(EffectBits, AreThoseOfEveryBuild) {
  const EffectHashes golden = golden_of(effect);
  std::string line = std::string("    {\"") + effect.name + "\", {";
  for (size_t v = 0; v < 4; ++v) {
    const uint64_t hash = hash_of(used, variants[v], TestWorld::one_thread());
    EXPECT_EQ(hash, golden.hashes[v]) << text_of(variants[v]);
    char digits[32];
    std::snprintf(digits, sizeof digits, "0x%016" PRIx64 "%s", hash, v < 3 ? ", " : "}},\n");
    line += digits;
  }
  if (HasFailure()) std::printf("%s", line.c_str());
}

/// One to four threads and every level; one pair for each variant, in turn, as time is dear.
TEST_P(EffectBits, DoNotDependOnThreadsOrLevel) {
  const EffectHashes golden = golden_of(effect);
  const std::vector<weft::Isa> isas = levels();
  for (size_t v = 0; v < 4; ++v) {
    weft::ContextDesc desc;
    desc.backend = weft::BackendKind::omp;
    desc.threads = uint32_t(1 + (v + 1) % 4);
    desc.isa = isas[v % isas.size()];
    EXPECT_EQ(hash_of(used, variants[v], desc), golden.hashes[v])
        << text_of(variants[v]) << ", " << desc.threads << " threads, " << name(desc.isa);
  }
}

TEST_P(EffectBits, AreNotThoseWithoutIt) {
  const weft::ContextDesc desc = TestWorld::one_thread();
  EXPECT_NE(hash_of(used, {}, desc), hash_of(unused, {}, desc));
}

INSTANTIATE_TEST_SUITE_P(Every, EffectBits,
                         testing::Range(size_t(0), weft::samples::effects.size()),
                         [](const auto& info) {
                           return std::string(weft::samples::effects[info.param].name);
                         });

TEST(EffectHashes, AreOfRowsOfTheTable) {
  for (const EffectHashes& golden : effect_hashes) {
    int rows = 0;
    for (const Effect& effect : weft::samples::effects) {
      rows += std::string_view(effect.name) == golden.effect;
    }
    EXPECT_EQ(rows, 1) << golden.effect;
  }
}

}  // namespace
}  // namespace weft_tests
