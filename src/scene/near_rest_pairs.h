// How many vertices of a fabric are near to each other at rest.
#pragma once

#include "scene/fabric.h"

namespace weft::scene {

/// Pairs of vertices whose positions at rest are nearer to each other than `distance` (strictly),
/// in double. Takes some bytes a vertex, whatever the number of pairs, and a time that grows with
/// those about `distance` apart: of what is all near, or all far, boxes are counted at once.
uint64_t near_rest_pairs(const CookedFabric&, double distance);

}  // namespace weft::scene
