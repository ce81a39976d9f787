#include "windless.h"

namespace weft::tools {

std::vector<Windless> windless_cloths(const io::Scene& scene, const io::RunningScene& made) {
  std::vector<Windless> found;
  if (!scene.wind) return found;
  for (size_t i = 0; i < scene.cloths.size(); ++i) {
    if (made.fabrics[i].triangle_count() > 0) continue;
    const bool network = !std::holds_alternative<io::GridShape>(scene.cloths[i].shape);
    found.push_back({i, "$.wind: cloth \"" + scene.cloths[i].name + "\" " +
                            (network ? "is a network" : "is one row or column") +
                            " (it has no triangles for wind to act on) use a " +
                            (network ? "grid or a mesh" : "wider grid") +
                            ", or leave out the wind"});
  }
  return found;
}

}  // namespace weft::tools
