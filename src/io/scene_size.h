// How much memory a scene takes, known before any of it is taken.
#pragma once

#include "io/scene.h"

namespace weft::io {

/// Bytes, as measured on large scenes and rounded up. What is built is springs, the triangles of
/// collider meshes and their grids; running needs the particles, too.
uint64_t bytes_to_build(const Scene&);
uint64_t bytes_to_run(const Scene&);

/// InputError when a world cannot hold so many particles, or this machine not what is built.
void require_buildable(const Scene&);
/// Why this machine cannot run the scene, with path and remedy; nothing when it can.
std::optional<std::string> beyond_memory(const Scene&);

/// Whether two colliders can share what is built of their triangles.
bool same_mesh(const MeshColliderScene&, const MeshColliderScene&);

}  // namespace weft::io
