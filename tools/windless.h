// Cloths that the wind of a scene passes through.
#pragma once

#include "io/build.h"

#include <string>
#include <vector>

namespace weft::tools {

struct Windless {
  size_t cloth;      ///< place in the scene
  std::string text;  ///< what a user is told, with the path and the cloth's name
};

/// The cloths without triangles of a scene with wind.
std::vector<Windless> windless_cloths(const io::Scene&, const io::RunningScene&);

}  // namespace weft::tools
