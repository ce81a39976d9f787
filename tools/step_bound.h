// The stable step of a scene, in words.
#pragma once

#include "io/build.h"

#include <cstdint>
#include <optional>
#include <string>

namespace weft::tools {

/// The fewest substeps of a frame with dt <= bound.
uint64_t fewest_substeps(double frame, double bound);

/// "cloth 'sheet', spring 12-14" or "cloth 'sheet', vertex 3".
std::string worst_element(const io::Scene&, const io::RunningScene&, const Stability&);

/// What is wrong with a fixed number of substeps that is beyond the bound; none when it is not.
std::optional<std::string> beyond_bound(const io::Scene&, const io::RunningScene&,
                                        const Stability&);

}  // namespace weft::tools
