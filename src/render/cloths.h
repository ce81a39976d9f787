// Cloths on the device.
#pragma once

#include "render/model.h"

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

/// What is drawn as round bars: springs of networks and of grids of one row or column; a vertex
/// that nothing else shows is a bar from itself to itself.
std::vector<std::array<uint32_t, 2>> bars(const io::Scene&, const io::Surface&);

class Cloths {
 public:
  /// `thickness`: m, of bars.
  Cloths(const io::Scene&, const io::Surface& start, float thickness);
  void update(const io::Surface&, const Vector3d& origin);
  void draw_sheets(const Program&) const;
  /// Instances of a capsule: their ends in slots 4 and 5, the radius in 6.
  void draw_bars(const Program&) const;

 private:
  struct Part {
    size_t first_index, index_count;
    float stripes;  ///< per metre
  };
  VertexArray array_;
  Buffer moving_, weave_, indices_;
  std::vector<Part> parts_;
  std::vector<std::array<uint32_t, 2>> bars_;
  Model bar_;
  Buffer bar_places_;
  float bar_radius_;
  std::vector<std::array<float, 6>> vertices_;  ///< position, normal: kept for its memory
};

}  // namespace weft::render
