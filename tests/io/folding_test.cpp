// A sheet that slides off a sphere and folds onto itself on the ground, as in figure 3 of Georgii
// and Westermann 2005: what the sample scene fold.json does, smaller.
#include <gtest/gtest.h>

#include <vector>

#include "io/build.h"
#include "io/crossings.h"
#include "io/scene.h"

namespace weft::io {
namespace {

constexpr uint32_t side = 64;

std::string folding_sheet(const char* self_collision) {
  return std::string(R"({
  "weft": 1,
  "cloths": [ { "name": "sheet",
    "grid": { "rows": 64, "columns": 64, "width": 1.0, "height": 1.0, "stencil": "seed12" },
    "transform": { "rotate": { "axis": [1, 0, 0], "degrees": 90 },
                   "translate": [-0.42, 0.62, -0.46] },
    "mass": 0.3, "stiffness": { "stretch": 30, "shear": 10, "bend": 0.5 },
    "damping": { "drag": 5e-5, "spring": 0.001 } } ],
  "colliders": [ { "sphere": { "center": [0, 0.3, 0], "radius": 0.3 }, "friction": 0.1 },
                 { "plane": { "normal": [0, 1, 0], "offset": 0 }, "friction": 0.4 } ],
  "self_collision": )") +
         self_collision + "}";
}

struct Outcome {
  size_t crossings;
  double kinetic_at_impact, kinetic;
};

Outcome run_for_two_seconds(const std::string& text) {
  const Scene scene = read_scene_text(text, "folding.json");
  ContextDesc context;
  context.threads = 1;
  RunningScene running = build(scene, context);
  Outcome out{};
  for (int frame = 0; frame < 120; ++frame) {
    running.require(running.world.step(1.0 / 60), "step");
    if (frame == 30) out.kinetic_at_impact = (*running.world.mechanics()).kinetic;
  }
  out.kinetic = (*running.world.mechanics()).kinetic;
  std::vector<double3> positions(side * side);
  running.require(running.world.read_positions(running.cloths[0], positions.data()), "read");
  out.crossings = crossings(positions, make_surface(scene, running).triangles).size();
  return out;
}

TEST(FoldingSheet, DoesNotCrossItselfAndComesToRest) {
  const Outcome out = run_for_two_seconds(
      folding_sheet(R"({ "method": "complete", "distance": 0.0167, "friction": 0.2 })"));
  EXPECT_EQ(out.crossings, 0u);
  EXPECT_LT(out.kinetic, 0.01 * out.kinetic_at_impact);
}

TEST(FoldingSheet, CrossesItselfWithoutSelfCollision) {
  EXPECT_GT(run_for_two_seconds(folding_sheet("null")).crossings, 100u);
}

}  // namespace
}  // namespace weft::io
