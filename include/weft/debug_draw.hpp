// Lines that show what a world is made of, for an engine's debug view.
#pragma once

#include "weft/world.hpp"

namespace weft {
inline namespace v0 {

/// What World::debug_draw shows; colours are 0xRRGGBBAA. A tool: it reads all positions back and is
/// not fast. `line` is called when the world has let go: it may call the world, and destroy it. A
/// line with an end that is not finite is left out.
struct DebugDraw {
  enum : uint32_t {
    springs = 1,    ///< white; redder the more one is stretched, bluer the more compressed
    pins = 2,       ///< yellow crosses
    colliders = 4,  ///< green: circles, edges; of meshes the box of what can touch; planes a square
    bounds = 8,     ///< grey: World::bounds of each cloth
    all = 15
  };
  void* user = nullptr;
  void (*line)(void* user, double3 a, double3 b, uint32_t rgba) = nullptr;  ///< m, in the world
  uint32_t what = all;
  double full_strain = 0.1;  ///< > 0: the strain of the strongest colour
};

}  // namespace v0
}  // namespace weft
