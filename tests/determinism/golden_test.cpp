// The same bits from every build: compares with a table that all compilers and configurations
// share.
#include "determinism/golden_hashes.h"

#include <cinttypes>
#include <cstdio>

namespace weft_tests {
namespace {

uint64_t hash_of(Scene scene, Variant variant) {
  TestWorld test(scene_world(variant));
  add_scene(test, scene);
  run_scene(test);
  return test.hash();
}

TEST(Golden, EveryBuildGivesTheSameBits) {
  for (Scene scene : all_scenes)
    for (weft::Precision precision : {weft::Precision::float32, weft::Precision::float64})
      for (weft::Form form : {weft::Form::summed, weft::Form::position}) {
        uint64_t expected = 0;
        for (const GoldenHash& golden : golden_hashes)
          if (golden.scene == scene && golden.variant.precision == precision &&
              golden.variant.form == form)
            expected = golden.hash;
        const uint64_t hash = hash_of(scene, {precision, form});
        EXPECT_EQ(hash, expected);
        if (hash != expected)
          std::printf("    {Scene::%s, {weft::Precision::%s, weft::Form::%s}, 0x%016" PRIx64 "},\n",
                      name(scene), weft::to_string(precision),
                      form == weft::Form::summed ? "summed" : "position", hash);
      }
}

TEST(Golden, InputIsTheSameInEveryBuild) {
  // Tells a compiler that changes the scenes from one that changes the simulation.
  uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](double value) {
    uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 0x100000001b3u;
  };
  reference::SplitMix random(21);
  for (Vec p : reference::grid_positions(41, 41)) {
    const Vec q = p + random.noise(0.2 / 41);
    add(q.x);
    add(q.y);
    add(q.z);
  }
  EXPECT_EQ(hash, golden_input);
}

}  // namespace
}  // namespace weft_tests
