// What is odd about a scene, from its files and from cooking: for check, and as warnings of run.
#pragma once

#include "io/build.h"

#include <optional>
#include <string>
#include <vector>

namespace weft::tools {

struct Remark {
  Severity severity;
  std::optional<size_t> cloth;     ///< in the scene
  std::optional<size_t> collider;  ///< the first of those that share the mesh
  uint32_t element;                ///< vertex, triangle or spring, as the text says
  std::string text;
};

/// Of mesh files, fabrics, cloths and collider meshes, in this order.
std::vector<Remark> remarks(const io::Scene&, io::RunningScene&);

/// "cloth 'NAME': " or "$.colliders[3]: "
std::string subject(const io::Scene&, const Remark&);

}  // namespace weft::tools
