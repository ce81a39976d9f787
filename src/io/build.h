// From a scene to a world.
#pragma once

#include "weft/weft.hpp"

#include "io/message_log.h"
#include "io/scene.h"
#include "io/surface.h"

#include <memory>
#include <vector>

namespace weft::io {

/// A scene at work. The members are in the order in which they depend on each other.
struct RunningScene {
  std::unique_ptr<MessageLog> log;
  Context context;
  std::vector<Fabric> fabrics;                ///< one per cloth of the scene
  std::vector<ColliderMesh> collider_meshes;  ///< different ones, in the order of first use
  World world;
  std::vector<ClothId> cloths;  ///< one per cloth of the scene

  /// Place of a cloth in the scene; cloths.size() when it is none of them.
  size_t index_of(ClothId) const;
  /// Throws CoreError with the library's last message when `status` is not ok.
  void require(Status status, const std::string& where) const;
};

/// `desc` says where it runs; its log is replaced. CoreError names the file and the JSON path.
RunningScene build(const Scene&, ContextDesc desc);

/// Triangles and edges of all cloths; the positions are zero.
Surface make_surface(const Scene&, const RunningScene&);

}  // namespace weft::io
