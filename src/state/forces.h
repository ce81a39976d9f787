// Constant forces on vertices.
#pragma once

#include "base/view.h"
#include "state/counts.h"

namespace weft {

template <class T>
struct Forces {
  Vec3Array<T> force;  ///< N

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    array(force, n.part[static_cast<int>(Part::forces)]);
  }
};

}  // namespace weft
