// The displacement of the last substep, whichever form keeps it.
#pragma once

#include "state/particles.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// x_n - x_(n-1) of particle i. `Position`: `d` holds x_(n-1).
template <bool Position, class T>
WEFT_HD Vec3<T> displacement(const ParticleBuffers<T>& p, int i) {
  if constexpr (Position) {
    return load(p.x_in, i) - load(p.d_in, i);
  } else {
    return load(p.d_in, i);
  }
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
