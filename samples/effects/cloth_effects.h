// What a cloth has of its own: drag, damping, forces, pins, sleep.
#pragma once

#include "samples/effects/effect.h"

namespace weft::samples {

/// Two vertices that every cloth has; of the sheets that are timed they are corners.
inline constexpr uint32_t pinned_vertices[] = {0, 255};
inline void hang(ClothDesc& d) {
  static constexpr Pin pins[] = {{pinned_vertices[0]}, {pinned_vertices[1]}};
  d.pins = View<Pin>(pins, 2);
}

inline constexpr Effect central_drag{
    .name = "central_drag",
    .used = {.line = "central drag, used", .dress = [](ClothDesc& d) { d.drag = 1e-5; }},
    .null = {{.dress = [](ClothDesc& d) { d.drag = 0; }}},
    .cloth_keys = R"("damping": {"drag": 1e-5})"};

inline constexpr Effect lagged_drag{
    .name = "lagged_drag",
    .used = {.line = "lagged drag, used",
             .dress =
                 [](ClothDesc& d) {
                   d.drag = 1e-5;
                   d.drag_model = DragModel::lagged;
                 }},
    .null = {{.dress = [](ClothDesc& d) { d.drag_model = DragModel::lagged; }}},
    .cloth_keys = R"("damping": {"drag": 1e-5, "drag_model": "lagged"})"};

inline constexpr Effect spring_damping{
    .name = "spring_damping",
    .used = {.line = "spring damping, used",
             .dress = [](ClothDesc& d) { d.spring_damping = 1e-5; }},
    .null = {{.dress = [](ClothDesc& d) { d.spring_damping = 0; }}},
    .cloth_keys = R"("damping": {"spring": 1e-5})"};

inline void push(ClothDesc& d) {
  static constexpr VertexForce forces[] = {{7, {0, 0.002, 0.001}}, {40, {0.001, 0, 0}}};
  d.forces = View<VertexForce>(forces, 2);
}
inline void push_with_nothing(ClothDesc& d) {
  static constexpr VertexForce forces[] = {{3, {0, 0, 0}}};
  d.forces = View<VertexForce>(forces, 1);
}
inline constexpr Effect constant_forces{
    .name = "constant_forces",
    .used = {.line = "constant forces, used", .dress = push},
    .null = {{.dress = push_with_nothing}},
    .cloth_keys = R"("forces": [{"vertices": [7], "force": [0, 0.002, 0.001]},
                                      {"vertices": [40], "force": [0.001, 0, 0]}])"};

inline void move_pins(ClothDesc& d) {
  static constexpr Pin pins[] = {{pinned_vertices[0], 0}, {pinned_vertices[1], 1}};
  static constexpr PinMotion motions[] = {{{0.1, 0, 0}, {0, 0.05, 0.1}, 5},
                                          {{0, 0, 0}, {0.1, 0, 0}, 23}};
  d.pins = View<Pin>(pins, 2);
  d.motions = View<PinMotion>(motions, 2);
}
inline void lead_pins_nowhere(ClothDesc& d) {
  static constexpr Pin pins[] = {{pinned_vertices[0], 0}, {pinned_vertices[1], 0}};
  static constexpr PinMotion motions[] = {{{0, 0, 0}, {0, 0, 0}, 5}};
  d.pins = View<Pin>(pins, 2);
  d.motions = View<PinMotion>(motions, 1);
}
inline constexpr Effect moving_pins{.name = "moving_pins",
                                    .used = {.line = "moving pins, used", .dress = move_pins},
                                    .null = {{.dress = lead_pins_nowhere}},
                                    .needs = {.dress = hang},
                                    .cloth_keys = R"("pins": [
            {"vertices": [0],
             "motion": {"velocity": [0.1, 0, 0], "amplitude": [0, 0.05, 0.1], "omega": 5}},
            {"vertices": [255], "motion": {"amplitude": [0.1, 0, 0], "omega": 23}}])"};

/// Pins that the caller moves, adds and releases between steps.
inline void lead_pins(Stage& s, int frame) {
  const uint32_t vertices[] = {3, 46};
  const double3 targets[] = {{0.1, 0.01 * frame, 0.1}, {1, 0.2, 0.02 * frame}};
  for (const ClothId id : s.cloths) {
    if (frame % 4 == 1) {
      check(s.world.move_pins(id, View<uint32_t>(vertices, 2), View<double3>(targets, 2)));
    } else if (frame == 8) {
      check(s.world.release_pins(id, View<uint32_t>(vertices, 1)));
    }
  }
}
inline constexpr Effect led_pins{.name = "led_pins", .used = {.lead = lead_pins}};

inline constexpr Effect tethers{
    .name = "tethers",
    .used = {.line = "tethers, used", .dress = [](ClothDesc& d) { d.tether_scale = 0.9; }},
    .null = {{.line = "tethers, out of reach",
              .dress = [](ClothDesc& d) { d.tether_scale = 1e6; }}},
    .needs = {.line = "two pins", .dress = hang},
    .cloth_keys = R"("pins": [0, 255], "tethers": {"scale": 0.9})"};
inline constexpr Effect soft_tethers{.name = "soft_tethers",
                                     .used = {.dress =
                                                  [](ClothDesc& d) {
                                                    d.tether_scale = 0.95;
                                                    d.tether_compliance = 0.01;
                                                  }},
                                     .null = {{.dress =
                                                   [](ClothDesc& d) {
                                                     d.tether_scale = 1e6;
                                                     d.tether_compliance = 0.01;
                                                   }}},
                                     .needs = {.dress = move_pins},
                                     .cloth_keys = R"("pins": [
            {"vertices": [0],
             "motion": {"velocity": [0.1, 0, 0], "amplitude": [0, 0.05, 0.1], "omega": 5}},
            {"vertices": [255], "motion": {"amplitude": [0.1, 0, 0], "omega": 23}}],
            "tethers": {"scale": 0.95, "compliance": 0.01})"};

inline void wake_the_first(Stage& s, int frame) {
  if (frame != 8) return;
  if (!take(s.world.asleep(s.cloths[0]))) throw std::runtime_error("no cloth sleeps");
  check(s.world.wake(s.cloths[0]));
}
inline constexpr Effect sleep{
    .name = "sleep",
    .used = {.dress =
                 [](ClothDesc& d) {
                   d.sleep_speed = 0.6;
                   d.sleep_time = 0.05;
                 },
             .lead = wake_the_first},
    .null = {{.line = "sleep, awake", .dress = [](ClothDesc& d) { d.sleep_speed = 1e-6; }}},
    .timed = {{.line = "sleep, asleep",
               .begin =
                   [](WorldDesc& w) {
                     w.gravity = {0, 0, 0};
                   },
               .dress =
                   [](ClothDesc& d) {
                     d.sleep_speed = 1e-3;
                     d.sleep_time = 0;
                   }}},
    .cloth_keys = R"("sleep": {"speed": 0.6, "time": 0.05})"};

inline constexpr Effect cloth_effects[] = {central_drag,    lagged_drag,  spring_damping,
                                           constant_forces, moving_pins,  led_pins,
                                           tethers,         soft_tethers, sleep};

}  // namespace weft::samples
