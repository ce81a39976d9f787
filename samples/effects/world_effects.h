// What a world has besides colliders: wind, self-collision, other ways to add forces up, and
// springs that are constraints.
#pragma once

#include "samples/effects/effect.h"

namespace weft::samples {

inline void blow(Stage& s) {
  WindDesc wind;
  wind.velocity = {0, 0, 5};
  check(s.world.set_wind(wind));
}
inline void turn_the_wind(Stage& s, int frame) {
  if (frame == 6) check(s.world.set_wind({{-3, 2, 5}, 1.2, 0.8, 0}));
}
inline void blow_and_clear(Stage& s) {
  blow(s);
  check(s.world.clear_wind());
}
inline constexpr Effect wind{.name = "wind",
                             .used = {.line = "wind, used", .furnish = blow, .lead = turn_the_wind},
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
                             .scene_keys = {R"("wind": {"velocity": [0, 0, 5]})"}};

template <Accumulate accumulate>
void scatter(WorldDesc& w) {
  w.evaluation = Evaluation::scatter;
  w.accumulate = accumulate;
}
/// Each spring evaluated once, its force added to both ends. `sum`: the name of `accumulate`.
template <Accumulate accumulate>
constexpr Effect scattered(const char* name, const char* sum) {
  return {.name = name,
          .used = {.begin = scatter<accumulate>},
          .scene_keys = {R"("solver": {"evaluation": "scatter", "accumulate": )", sum, "}"}};
}
constexpr Effect timed_scatter(Effect effect) {
  effect.used.line = "scatter fixed64, used";
  effect.null[0] = {.line = "scatter native, the gather's bits",
                    .begin = scatter<Accumulate::native>};
  return effect;
}

/// Springs are constraints: no forces that a scatter could add up.
inline void project(WorldDesc& w) {
  w.integrator = Integrator::xpbd;
  w.form = Form::summed;
  w.evaluation = Evaluation::automatic;
  w.accumulate = Accumulate::native;
}
inline void project_with_ladder(WorldDesc& w) {
  project(w);
  w.ladder[0] = 4;
  w.ladder[1] = 2;
}
inline void project_without_ladder(WorldDesc& w) {
  project(w);
  w.ladder[0] = 0;
}
inline constexpr Effect xpbd{
    .name = "xpbd",
    .used = {.begin = project},
    .null = {{.begin = [](WorldDesc& w) { w.ladder[0] = 8; }}},
    .timed = {{.line = "xpbd in place of forces", .begin = project_without_ladder}},
    .scene_keys = {R"("solver": {"integrator": "xpbd"})"}};
inline constexpr Effect xpbd_ladder{
    .name = "xpbd_ladder",
    .used = {.line = "the same with long springs", .begin = project_with_ladder},
    .scene_keys = {R"("solver": {"integrator": "xpbd", "ladder": [4, 2]})"}};

/// Below the spacing of the scene's sheet, which shrinks a little: then neighbours touch.
inline void come_near(ClothDesc& d) { d.collision_distance = 0.06245; }
/// Less than a vertex is from the next one of the sheet that is timed.
inline void come_less_near(ClothDesc& d) { d.collision_distance = 0.0035; }
inline void avoid_all(ClothDesc& d) {
  come_near(d);
  d.collides_itself = d.collides_others = 0;
}
template <PairSearch search>
void collide(Stage& s) {
  SelfCollisionDesc desc;
  desc.search = search;
  desc.friction = 0.25;
  desc.cell = 0.125;
  check(s.world.set_self_collision(desc));
}
/// So near is nobody.
template <PairSearch search>
void collide_in_vain(Stage& s) {
  SelfCollisionDesc desc;
  desc.search = search;
  desc.distance = 1e-7;
  desc.skin = 1e-3;
  check(s.world.set_self_collision(desc));
}
template <PairSearch search>
void collide_and_clear(Stage& s) {
  collide<search>(s);
  check(s.world.clear_self_collision());
}
template <PairSearch search>
constexpr Effect self_collision(const char* name, const char* method) {
  return {.name = name,
          .used = {.dress = come_near, .furnish = collide<search>},
          .null = {{.furnish = collide_in_vain<search>},
                   {.dress = avoid_all, .furnish = collide<search>},
                   {.dress = come_near, .furnish = collide_and_clear<search>}},
          .cloth_keys = R"("collision": {"distance": 0.06245})",
          .scene_keys = {R"("self_collision": {"friction": 0.25, "cell": 0.125, "method": )",
                         method, "}"}};
}

constexpr Effect timed_collision(Effect effect) {
  effect.timed[0] = {.line = "self-collision, nobody near",
                     .dress = come_less_near,
                     .furnish = collide<PairSearch::complete>};
  return effect;
}

inline constexpr Effect world_effects[] = {
    wind,
    timed_collision(self_collision<PairSearch::complete>("self_collision", R"("complete")")),
    self_collision<PairSearch::staggered>("staggered_grids", R"("staggered")"),
    timed_scatter(scattered<Accumulate::fixed64>("scatter_fixed64", R"("fixed64")")),
    scattered<Accumulate::float16>("scatter_float16", R"("float16")"),
    scattered<Accumulate::float24>("scatter_float24", R"("float24")"),
    scattered<Accumulate::float24_all>("scatter_float24_all", R"("float24_all")"),
    scattered<Accumulate::fixed8>("scatter_fixed8", R"("fixed8")"),
    xpbd,
    xpbd_ladder};

}  // namespace weft::samples
