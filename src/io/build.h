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
  std::vector<Fabric> fabrics;  ///< one per cloth of the scene
  /// By cloth and vertex of the scene: its particle; empty where each vertex is one.
  std::vector<std::vector<uint32_t>> particles;
  std::vector<ColliderMesh> collider_meshes;  ///< different ones, in the order of first use
  std::vector<size_t> mesh_colliders;         ///< the first collider of the scene with each
  World world;
  std::vector<ClothId> cloths;  ///< one per cloth of the scene

  /// Place of a cloth in the scene; cloths.size() when it is none of them.
  size_t index_of(ClothId) const;
  /// Throws CoreError with the library's last message when `status` is not ok.
  void require(Status status, const std::string& where) const;
};

/// `desc` says where it runs; its log is replaced. CoreError names the file and the JSON path.
RunningScene build(const Scene&, ContextDesc desc);

SelfCollisionDesc self_collision_desc(const SelfCollisionScene&);

/// Triangles and edges of all cloths, by vertices of the scene; the positions are zero.
Surface make_surface(const Scene&, const RunningScene&);

/// The springs of a network, or beside the edges of a mesh; null for grids.
const std::vector<Spring>* lines_of(const Shape&);
/// Vertices of a cloth in the scene; welded ones count.
size_t vertex_count(const RunningScene&, size_t cloth);
/// From a value per particle, at the begin of `values`, to a value per vertex of the scene.
void spread(const RunningScene&, size_t cloth, double3* values);

/// `text` of the library, with the number of the file's face beside that of a triangle where
/// polygons were cut: "triangle 7 (face 3)".
std::string with_faces(const std::string& text, const Mesh&);

}  // namespace weft::io
