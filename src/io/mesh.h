// Triangle meshes as files have them.
#pragma once

#include "weft/fabric.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace weft::io {

struct Mesh {
  std::vector<double3> positions;
  std::vector<uint32_t> triangles;  ///< 3 per triangle, each below positions.size()
  /// By triangle: the face of the file that it is cut from, from 0; empty when all are triangles.
  std::vector<uint32_t> faces;
  std::vector<Spring> lines;          ///< beside the faces: lines of OBJ, edges of PLY
  std::vector<std::string> warnings;  ///< what was skipped or looked odd
};

/// Bytes: half of this machine's memory.
uint64_t largest_mesh_memory();

/// Reads OBJ or PLY, told apart by the first bytes; polygons are cut (io/polygon.h). A mesh without
/// triangles is not an error here; one without vertices is. InputError names the file, the line or
/// element, the value. Text and mesh together, and what reading takes besides, have at most
/// `most_bytes`.
Mesh read_mesh(const std::string& path, uint64_t most_bytes = largest_mesh_memory());

/// The same from memory; `name` goes into messages.
Mesh read_obj(std::string_view text, const std::string& name,
              uint64_t most_bytes = largest_mesh_memory());
Mesh read_ply(std::string_view text, const std::string& name,
              uint64_t most_bytes = largest_mesh_memory());

}  // namespace weft::io
