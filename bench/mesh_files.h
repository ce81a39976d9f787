// Meshes that nobody here made, where they are installed.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace weft::bench {

/// Name and path.
std::vector<std::pair<std::string, std::string>> mesh_files();

}  // namespace weft::bench
