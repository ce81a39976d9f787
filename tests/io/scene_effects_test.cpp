// Every row of the table of effects as a scene file: the reader takes its keys, and they do what
// the row does through the interface.
#include "io/build.h"
#include "samples/effects/effects.h"
#include "samples/effects/scene_text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace weft::io::test {
namespace {

using samples::Changes;
using samples::Effect;
using Json = nlohmann::json;

constexpr int frames = 20;

ContextDesc one_thread() {
  ContextDesc desc;
  desc.backend = BackendKind::omp;
  desc.threads = 1;
  return desc;
}

uint64_t hash_after_frames(World& world) {
  for (int frame = 0; frame < frames; ++frame) samples::check(world.step(1.0 / 60));
  return samples::take(world.state_hash());
}
uint64_t hash_of_scene(const std::string& text) {
  RunningScene made = build(read_scene_text(text, "effect.json"), one_thread());
  return hash_after_frames(made.world);
}
/// The same sheet with `changes`, without a scene file.
uint64_t hash_of(const Changes& changes) {
  Context context = samples::take(Context::create(one_thread()));
  WorldDesc desc;
  desc.gravity = samples::down;
  samples::begin(changes, desc);
  World world = samples::take(context.create_world(desc));
  ClothDesc cloth;
  cloth.fabric = samples::take(context.cook(samples::sheet_of_scene()));
  cloth.pose = samples::pose_of_scene();
  samples::dress(changes, cloth);
  samples::Stage stage{context, world, {samples::take(world.create_cloth(cloth))}, {}};
  samples::furnish(changes, stage);
  return hash_after_frames(world);
}

std::vector<const Effect*> rows_with_keys() {
  std::vector<const Effect*> found;
  for (const Effect& effect : samples::effects) {
    if (effect.has_keys()) found.push_back(&effect);
  }
  return found;
}

class SceneEffects : public testing::TestWithParam<const Effect*> {};

TEST_P(SceneEffects, DoWhatTheRowDoes) {
  const Effect& effect = *GetParam();
  const uint64_t used = hash_of({&effect.needs, &effect.used});
  EXPECT_EQ(hash_of_scene(samples::scene_text(effect)), used);
  EXPECT_NE(hash_of({&effect.needs}), used) << "the row changes nothing";
}

/// Its members' names in the table of a cloth's or a scene's keys.
TEST_P(SceneEffects, AreInTheDocument) {
  std::ifstream file(WEFT_SCENE_FORMAT);
  const std::string document{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(document.empty());
  const Json cloth = Json::parse(std::string("{") + GetParam()->cloth_keys + "}");
  for (const auto& member : cloth.items()) {
    EXPECT_NE(document.find("| `" + member.key() + "`"), std::string::npos) << member.key();
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, SceneEffects, testing::ValuesIn(rows_with_keys()),
                         [](const auto& info) { return std::string(info.param->name); });

TEST(SceneEffectsBase, SheetIsTheScenes) {
  EXPECT_EQ(hash_of_scene(samples::scene_text("", "")), hash_of({}));
}

}  // namespace
}  // namespace weft::io::test
