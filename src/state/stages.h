// The optional stages of a substep, in their order. All are compiled; a build that leaves some out
// exists to show that a stage which is not used costs nothing (tests/hygiene).
#pragma once

#include "base/portability.h"

namespace weft {

enum class Stage : uint32_t {
  sleep,           ///< blocks of sleeping cloths do nothing
  forces,          ///< constant forces of vertices
  spring_damping,  ///< along the springs
  wind,            ///< on triangles
  tethers,         ///< back to within a distance of the pins
  contacts,        ///< apart from other particles
  colliders,       ///< out of the shapes, with friction
  moving_pins      ///< pins that are not where they were
};

/// What some cloths have in arrays of its own, which hold these cloths' particles and no others.
enum class Part : int32_t { forces, tethers };
constexpr int part_count = 2;

WEFT_HD constexpr bool is_compiled(Stage stage) {
  return ((WEFT_LEAVE_OUT_STAGES >> static_cast<uint32_t>(stage)) & 1u) == 0;
}

/// The stages that a pass is made of: bit k is Stage k.
using StageSet = uint32_t;
constexpr StageSet every_stage = ~StageSet(0);
WEFT_HD constexpr StageSet without(StageSet set, Stage stage) {
  return set & ~(StageSet(1) << static_cast<uint32_t>(stage));
}
WEFT_HD constexpr bool contains(StageSet set, Stage stage) {
  return is_compiled(stage) && without(set, stage) != set;
}

}  // namespace weft
