// Settings of self-collision with which staggered grids miss pairs by construction.
#pragma once

#include "io/scene.h"

#include <string>
#include <vector>

namespace weft::tools {

struct MissedPairs {
  bool grave;        ///< even pairs that a cell has room for are too far apart for it
  std::string text;  ///< with the path, why, and what would find all
};

std::vector<MissedPairs> missed_pairs(const io::Scene&);

}  // namespace weft::tools
