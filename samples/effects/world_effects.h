// What a world has besides colliders: wind, and other ways to add forces up.
#pragma once

#include "samples/effects/effect.h"

namespace weft::samples {

template <int speed>
void blow(Stage& s) {
  WindDesc wind;
  wind.velocity = {0, 0, speed};
  check(s.world.set_wind(wind));
}
inline void turn_the_wind(Stage& s, int frame) {
  if (frame == 6) check(s.world.set_wind({{-3, 2, 5}, 1.2, 0.8, 0}));
}
inline void blow_and_clear(Stage& s) {
  blow<5>(s);
  check(s.world.clear_wind());
}
inline Effect wind() {
  return {.name = "wind",
          .used = {.line = "wind, used", .furnish = blow<5>, .lead = turn_the_wind},
          .null = {{.line = "wind without air",
                    .furnish =
                        [](Stage& s) {
                          check(s.world.set_wind({{9, 5, 7}, 0, 1, 1}));
                        }},
                   {.furnish =
                        [](Stage& s) {
                          check(s.world.set_wind({{9, 5, 7}, 1.225, 0, 0}));
                        }},
                   {.furnish = blow_and_clear}},
          .scene_keys = R"("wind": {"velocity": [0, 0, 5]})"};
}

template <Accumulate accumulate>
void scatter(WorldDesc& w) {
  w.evaluation = Evaluation::scatter;
  w.accumulate = accumulate;
}
/// Each spring evaluated once, its force added to both ends. Native sums have the gather's bits.
template <Accumulate accumulate>
Effect scattered() {
  const std::string sum = to_string(accumulate);
  return {.name = "scatter_" + sum,
          .used = {.begin = scatter<accumulate>},
          .scene_keys = R"("solver": {"evaluation": "scatter", "accumulate": ")" + sum + "\"}"};
}
inline Effect scattered_fixed64() {
  Effect effect = scattered<Accumulate::fixed64>();
  effect.used.line = "scatter fixed64, used";
  effect.null = {
      {.line = "scatter native, the gather's bits", .begin = scatter<Accumulate::native>}};
  return effect;
}

inline std::vector<Effect> world_effects() {
  return {wind(),
          scattered_fixed64(),
          scattered<Accumulate::float16>(),
          scattered<Accumulate::float24>(),
          scattered<Accumulate::float24_all>(),
          scattered<Accumulate::fixed8>()};
}

}  // namespace weft::samples
