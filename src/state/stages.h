// The optional stages of a substep, in their order. All are compiled; a build that leaves some out
// exists to show that a stage which is not used costs nothing (tests/hygiene).
#pragma once

#include "base/portability.h"

namespace weft {

enum class Stage : uint32_t {
  sleep,           ///< blocks of sleeping cloths do nothing
  forces,          ///< constant forces of vertices
  wind,            ///< on triangles
  spring_damping,  ///< along the springs
  colliders,       ///< out of the shapes, with friction
  moving_pins      ///< pins that are not where they were
};

constexpr bool is_compiled(Stage stage) {
  return ((WEFT_LEAVE_OUT_STAGES >> static_cast<uint32_t>(stage)) & 1u) == 0;
}

}  // namespace weft
