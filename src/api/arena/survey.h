// What the records learn from a survey of their cloths.
#pragma once

#include "api/arena/arena.h"
#include "base/host_memory.h"

namespace weft::api {

/// Bounds, longest way and loss of every cloth, from its groups.
template <class T>
void take_survey(const ArenaInput&, const Vector<Survey<T>>& groups);

}  // namespace weft::api
