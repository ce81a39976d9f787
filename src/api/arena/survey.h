// What the records learn from a survey of their cloths.
#pragma once

#include "api/arena/arena.h"

namespace weft::api {

/// Bounds, longest way and loss of every cloth, from its groups.
template <class T>
void take_survey(const ArenaInput&, const std::vector<Survey<T>>& groups);

}  // namespace weft::api
