// A scene file with one effect of the table, and the same sheet for who has no scene file.
#pragma once

#include "samples/effects/effect.h"

#include <string>

namespace weft::samples {

/// A sheet about the unit square that shrinks a little. With a comma before keys that are there.
inline std::string scene_text(const std::string& cloth_keys, const std::string& scene_keys) {
  const auto more = [](const std::string& keys) { return keys.empty() ? "" : ",\n  " + keys; };
  return R"({
  "weft": 1,
  "gravity": [0, 0, -9.81],
  "time": {"duration": 0.3333},
  "cloths": [{
    "name": "sheet",
    "grid": {"rows": 16, "columns": 17, "width": 1, "height": 0.9375, "stencil": "quad4"},
    "mass": 1,
    "stiffness": 100,
    "rest_length": 0.0624,
    "transform": {"rotate": {"axis": [1, 2, 3], "degrees": 2}})" +
         more(cloth_keys) + "}]" + more(scene_keys) + "\n}\n";
}
inline std::string scene_text(const Effect& effect) {
  std::string scene_keys;
  for (const char* piece : effect.scene_keys) scene_keys += piece ? piece : "";
  return scene_text(effect.cloth_keys, scene_keys);
}

inline GridDesc sheet_of_scene() {
  GridDesc grid;
  grid.rows = 16;
  grid.columns = 17;
  grid.height = 0.9375;
  grid.stencil = Stencil::quad4;
  grid.material.rest_length = 0.0624;
  return grid;
}
inline Pose pose_of_scene() { return {{1, 2, 3}, 2, {0, 0, 0}}; }

}  // namespace weft::samples
