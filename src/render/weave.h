// What of a cloth does not change from picture to picture.
#pragma once

#include "render/box.h"

#include "io/scene.h"
#include "io/surface.h"

#include <array>
#include <vector>

namespace weft::render {

/// Where the threads of a vertex run: coordinates in metres along three axes, and how much each of
/// these planes faces out (x: yz, y: zx, z: xy). A grid has its own xy; a mesh is projected from
/// three sides at its first positions.
using WeaveVertex = std::array<float, 6>;
std::vector<WeaveVertex> weave_vertices(const io::Scene&, const io::Surface& start);

/// By vertex: whether it is one of a mesh without a triangle, which is not drawn.
std::vector<bool> loose_vertices(const io::Scene&, const io::Surface&);

/// What is drawn as round bars: springs of networks and of grids of one row or column; a vertex
/// that nothing else shows is a bar from itself to itself, but in a mesh.
std::vector<std::array<uint32_t, 2>> bars(const io::Scene&, const io::Surface&);

}  // namespace weft::render
