// What the records learn from a survey of their cloths.
#pragma once

#include "api/arena/arena.h"
#include "base/memory_host.h"

namespace weft::api {

/// Bounds, middle, longest way and loss of every cloth, from its groups.
template <class T>
void take_survey(const ArenaInput&, const Vector<Survey<T>>& groups);

/// How far the origin of a cloth goes to follow it, whole metres: zero until it can go without
/// rounding, which is when most of the cloth lies on one side of it.
double3 way_of_origin(const ClothRecord&);

}  // namespace weft::api
