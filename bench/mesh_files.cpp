#include "bench/mesh_files.h"

#include <filesystem>

namespace weft::bench {

std::vector<std::pair<std::string, std::string>> mesh_files() {
  std::vector<std::pair<std::string, std::string>> found;
  for (const auto& [name, file] :
       {std::pair{"spot", WEFT_SHARED_DATA "/spot.obj"},
        std::pair{"bunny", WEFT_SHARED_DATA "/stanford-bunny.obj"},
        std::pair{"teapot", WEFT_SHARED_DATA "/teapot.obj"},
        std::pair{"wuson", "/usr/share/assimp/models/OBJ/WusonOBJ.obj"}}) {
    if (std::filesystem::exists(file)) found.emplace_back(name, file);
  }
  return found;
}

}  // namespace weft::bench
