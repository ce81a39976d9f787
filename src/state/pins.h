// Moving pins, stored for the blocks that have any: 32 lanes a block, like the particles.
//
// Target at the end of a substep: base + fraction * glide + offset of the motion. Pins that never
// move are particles of inverse mass 0 and appear nowhere here.
#pragma once

#include "base/view.h"
#include "state/counts.h"

namespace weft {

template <class T>
struct MovingPins {
  const int32_t* of_block;  ///< per block: its block of moving pins, or -1; null without any
  Vec3Array<T> base;        ///< position without its motion at the start of the frame
  Vec3Array<T> glide;       ///< distance that a moved pin travels in this frame
  const int32_t*
      motion;  ///< index into the motions' offsets; 0 is "no motion"; -1: not a moving pin
  const Vec3<T>* offset;  ///< [substep][motion]: where each motion is at the end of the substep
  int motions;

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    const int64_t pins = n.pin_blocks * block_size;
    array(of_block, pins > 0 ? n.particles / block_size : 0);
    array(base, pins);
    array(glide, pins);
    array(motion, pins);
    array(offset, pins > 0 ? n.motions * n.substeps : 0);
    array.number(motions, n.motions);
  }
};

}  // namespace weft
