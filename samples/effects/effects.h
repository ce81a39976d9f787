// The table of effects. A row here and its line in tests/determinism/golden_hashes.h are all that
// `weft bench effects`, the tests and the fuzzer need to cover a new effect.
#pragma once

#include "samples/effects/cloth_effects.h"
#include "samples/effects/collider_effects.h"
#include "samples/effects/mesh_effects.h"
#include "samples/effects/world_effects.h"

namespace weft::samples {

inline std::vector<Effect> make_effects() {
  std::vector<Effect> all;
  for (const auto rows :
       {cloth_effects, world_effects, shape_effects, group_effects, mesh_effects}) {
    for (Effect& row : rows()) all.push_back(std::move(row));
  }
  return all;
}

inline const std::vector<Effect>& effects() {
  static const std::vector<Effect> all = make_effects();
  return all;
}

}  // namespace weft::samples
