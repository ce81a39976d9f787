// How point caches and the frames beside them are called.
#pragma once

#include <string>
#include <vector>

namespace weft::tools {

/// "frame_" and at least six digits.
bool is_frame_stem(const std::string& name);

/// A file name, without extension, for each cloth: what no file can be called becomes "_"; names
/// that are equal but for the case of their letters, or those of frames, get a number behind them.
std::vector<std::string> cache_names(const std::vector<std::string>& cloths);

}  // namespace weft::tools
