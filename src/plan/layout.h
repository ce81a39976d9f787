// Where everything lies in the one block of device memory of a world. The plan predicts from it and
// the back end's memory is cut by it, so the two cannot differ.
#pragma once

#include <cstddef>
#include <cstdint>

#include "plan/effects.h"

namespace weft::plan {

/// Byte offset of an array, or absent.
constexpr size_t absent = ~size_t(0);

struct VectorArray {
  size_t offset = absent;  ///< byte of element 0, behind the guard band
  size_t pitch = 0;        ///< scalars from x to y to z
};

struct EdgeLayout {
  size_t cloth = absent, a = absent, b = absent, rest = absent, stiffness = absent;
  VectorArray force, damping, total;
  size_t start = absent, incident = absent;
  size_t fixed = absent, overflow = absent, largest = absent;
};
struct HubLayout {
  size_t of_block = absent, hub = absent, chunk = absent, force = absent, damping = absent;
};

struct Layout {
  VectorArray x[3], d[2];
  VectorArray before;  ///< positions before the last frame
  size_t inverse_mass = absent, presence = absent;
  size_t block_cloth = absent, block_inner = absent, block_pins = absent;
  size_t cloths = absent;
  size_t slice_start = absent, neighbour = absent, rest = absent, stiffness = absent;
  EdgeLayout edges;
  HubLayout hubs;
  VectorArray force;
  size_t triangle_start = absent, triangle_next = absent, triangle_last = absent;
  size_t colliders[collider_shapes] = {absent, absent, absent, absent, absent, absent};
  size_t turn = absent, near = absent, near_reach = absent;
  size_t activity = absent, block_reach = absent, near_memory = absent;
  std::vector<MeshArrays> meshes;  ///< offsets, in the order of WorldShape::meshes
  size_t survey_ranges = absent, survey = absent;
  VectorArray pin_base, pin_glide;
  size_t pin_motion = absent, pin_offset = absent;
  size_t bytes = 0;
};

/// `particle_step`: how the back end stores vectors (base/portability.h).
Layout lay_out(const WorldShape&, int particle_step);

}  // namespace weft::plan
