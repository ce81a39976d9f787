// The device memory of a world as the kernels see it.
#pragma once

#include "api/arena/arena.h"

namespace weft::api {

/// The arrays of an image (or of device memory) at `base`.
template <class T>
Simulation<T> views_of(const plan::Layout&, const plan::Plan&, const plan::WorldShape&, char* base);

}  // namespace weft::api
