// The pieces of the scene reader; each takes the node of its key and fills its part.
#pragma once

#include "io/json_node.h"
#include "io/scene.h"

#include <map>

namespace weft::io {

/// Where mesh files are, and those that were read.
struct MeshCache {
  std::string folder;
  std::map<std::string, std::shared_ptr<const Mesh>> meshes;  ///< by path without detours
  uint64_t bytes = 0;                                         ///< of all of them
};

void read_time(const Node&, TimeSettings&);
void read_solver(const Node&, SolverSettings&);
ClothScene read_cloth(const Node&, MeshCache&);
Shape read_shape(const Node& cloth, MeshCache&);
/// The mesh of a file, read once.
std::shared_ptr<const Mesh> load_mesh(const Node& file, MeshCache&);
void read_material(const Node& cloth, ClothScene&);
void read_pins(const Node&, ClothScene&);
/// `{ "scale", "rotate", "translate" }`
void read_transform(const Node&, double& scale, Pose&);
/// `{ "axis", "degrees" }`
void read_rotation(const Node&, double3& axis, double& degrees);
/// A mask of 32 bits.
uint32_t read_layers(const Node&);
ColliderScene read_collider(const Node&, MeshCache&);
std::optional<WindDesc> read_wind(const Node&);
std::optional<SelfCollisionScene> read_self_collision(const Node&);
CameraScene read_camera(const Node&);

/// Refuses what is valid but has no effect yet, naming path and value.
void refuse_unavailable(const Scene&);

}  // namespace weft::io
