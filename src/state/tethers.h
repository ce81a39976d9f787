// Tethers: how far a particle may be from the nearest pin.
#pragma once

#include "base/view.h"
#include "state/counts.h"

namespace weft {

template <class T>
struct Tethers {
  const int32_t* pin;     ///< element of its pin; of one without a tether: itself
  const T* limit;         ///< m; infinite without a tether
  const int32_t* common;  ///< by block: the pin of all of its tethers, or several_pins

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    array(pin, n.part[static_cast<int>(Part::tethers)]);
    array(limit, n.part[static_cast<int>(Part::tethers)]);
    array(common, n.part[static_cast<int>(Part::tethers)] / block_size);
  }
};

constexpr int32_t several_pins = -1;

}  // namespace weft
