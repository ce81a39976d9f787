// The table of effects (samples/effects) leaves out nothing that a cloth can have.
#include "api/arena/parts.h"
#include "reference/effect_world.h"

#include <gtest/gtest.h>

namespace weft_tests {
namespace {

/// One that names it in a scene, and says what leaves it without effect.
TEST(EffectsTable, HasARowForEveryNumberOfACloth) {
  for (const weft::ClothNumber& number : weft::cloth_numbers) {
    bool used = false;
    for (const Effect& effect : weft::samples::effects) {
      weft::ClothDesc cloth;
      weft::samples::dress({&effect.needs, &effect.used}, cloth);
      const bool changes = cloth.*number.value != weft::ClothSettings{}.*number.value;
      used |= changes && *effect.cloth_keys && effect.null[0];
    }
    EXPECT_TRUE(used) << number.name << ": used, in the keys of a scene, and with a null effect";
  }
}

TEST(EffectsTable, HasARowForEveryPart) {
  weft::Context context = weft::samples::take(weft::Context::create());
  std::string kernels;
  for (const Effect& effect : weft::samples::effects) {
    EffectWorld made(context, {}, {&effect.needs, &effect.used});
    const weft::PlanInfo plan = weft::samples::take(made.world().plan());
    for (uint32_t k = 0; k < plan.passes.count; ++k) kernels += plan.passes[k].kernel;
  }
  weft::api::Parts::each([&](auto part) {
    EXPECT_NE(kernels.find(std::string(" +") + part.name), std::string::npos) << part.name;
  });
}

}  // namespace
}  // namespace weft_tests
