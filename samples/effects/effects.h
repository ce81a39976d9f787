// The table of effects. A row here and its line in tests/determinism/golden_hashes.h are all that
// `weft bench effects`, the tests and the fuzzer need to cover a new effect.
#pragma once

#include "samples/effects/cloth_effects.h"
#include "samples/effects/collider_effects.h"
#include "samples/effects/mesh_effects.h"
#include "samples/effects/world_effects.h"

#include <array>

namespace weft::samples {

template <size_t... n>
constexpr std::array<Effect, (n + ...)> joined(const Effect (&... rows)[n]) {
  std::array<Effect, (n + ...)> all{};
  size_t count = 0;
  const auto append = [&](const auto& some) {
    for (const Effect& row : some) all[count++] = row;
  };
  (append(rows), ...);
  return all;
}
inline constexpr auto effects =
    joined(cloth_effects, world_effects, shape_effects, group_effects, mesh_effects);

}  // namespace weft::samples
