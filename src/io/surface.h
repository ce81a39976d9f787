// What a frame shows: all cloths of a world as one indexed surface.
#pragma once

#include "weft/core.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace weft::io {

/// A cloth's place in the arrays of a surface.
struct SurfacePart {
  std::string name;
  size_t first_vertex = 0, vertex_count = 0;
  size_t first_triangle = 0, triangle_count = 0;
  size_t first_edge = 0, edge_count = 0;
};

/// Indices count through all parts. Edges are given for networks only, which have no triangles.
struct Surface {
  std::vector<double3> positions;
  std::vector<double3> normals;  ///< empty, or one per position
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<std::array<uint32_t, 2>> edges;
  std::vector<SurfacePart> parts;
};

/// Text: an object per part; numbers in the fewest digits that read back as the same value of
/// `precision`. Vertex i has normal i; a surface without normals is written without.
void write_obj(const std::string& path, const Surface&, Precision, bool with_normals = true);
/// Little-endian binary: float or double positions and normals by `precision`.
void write_ply(const std::string& path, const Surface&, Precision, bool with_normals = true);

}  // namespace weft::io
