// Fills an image of a world's device memory from the records.
#pragma once

#include "api/arena/arena.h"
#include "base/memory_host.h"
#include "plan/device_arrays.h"

namespace weft::api {

/// Everything but colliders, pins and motions, which change from frame to frame. The image is 0.
/// `dt`: of the substep to come.
template <class T>
void fill_image(const ArenaInput&, int vector_stride, double dt, double time,
                plan::DeviceArrays<T>& image);

/// Parameters of the cloths; `starting` marks those that have not moved.
template <class T>
void fill_params(const ArenaInput&, Vector<ClothParams<T>>& out);

}  // namespace weft::api
