// What is going on where: which colliders a cloth, and each of its blocks, can touch in this frame,
// and which cloths are asleep.
//
// A list of near colliders holds as long as the particles stay in the region that it was made for.
// That is looked at in every substep; whoever has left it meets all colliders. So what is left out
// never changes a bit, only the time.
#pragma once

#include "state/colliders.h"

namespace weft {

enum class Nearness : int32_t {
  every,  ///< all colliders may touch the cloth
  cloth,  ///< the list of the cloth
  block   ///< the list of the cloth, and of its entries those in the mask of the block
};

/// Of one cloth in one frame.
template <class T>
struct ClothActivity {
  Nearness nearness;
  int near_first[collider_shapes], near_end[collider_shapes];
  Vec3<T> low, high;  ///< Nearness::cloth: the region that its list is made for
  T margin;           ///< m: how far the particles are expected to travel in the frame
  int asleep;
  int settling;  ///< substeps in which a sleeping cloth still copies its state to the next buffer
};

/// Of one block in one frame.
template <class T>
struct BlockReach {
  Vec3<T> low, high;  ///< region
  uint64_t mask;      ///< bit j: entry near_first[0] + j of the cloth's list, j < 64
};

/// Of a group of blocks of one cloth, after a frame.
constexpr int survey_samples = 5;
template <class T>
struct Survey {
  Vec3<T> sample[survey_samples];  ///< of positions, evenly spread in the order of storage
  Vec3<T> low, high;               ///< of the finite positions
  T furthest2;                     ///< m^2: largest squared displacement of the last substep
  int32_t broken;                  ///< particles whose position is not finite
};
constexpr int survey_blocks = 32;

/// Elements of one group: its real particles.
struct SurveyRange {
  int32_t first, end;
};

}  // namespace weft
