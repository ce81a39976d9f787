// How much memory a scene takes, known before any of it is taken.
#pragma once

#include "io/scene.h"

#include <tuple>

namespace weft::io {

/// Bytes, as measured on large scenes and rounded up. What is built is springs, the triangles of
/// collider meshes and their grids; running needs the particles of grids, too, and what they need
/// at least. How much they do in truth is known when the scene is built.
uint64_t bytes_to_build(const Scene&);
uint64_t bytes_to_run(const Scene&);
/// `planned`: what World::plan says.
uint64_t bytes_to_run(const Scene&, uint64_t planned);

/// InputError when a world cannot hold so many particles, or this machine not what is built.
void require_buildable(const Scene&);
/// Why this machine cannot run a scene that takes so much, with path and remedy; nothing when it
/// can.
std::optional<std::string> beyond_memory(uint64_t bytes);

/// Colliders for which this is equal can share what is built of their triangles.
using MeshKey = std::tuple<const Mesh*, double, double, bool, double>;
MeshKey key_of(const MeshColliderScene&);

}  // namespace weft::io
