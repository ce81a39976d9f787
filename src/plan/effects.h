// What a world's cloths need, in numbers: all that a plan depends on.
#pragma once

#include <vector>

#include "state/simulation.h"
#include "weft/core.hpp"

namespace weft::plan {

/// One cloth, in arena order.
struct ClothShape {
  KernelKind kind;
  uint32_t particles;
  uint64_t directed_springs;
  int64_t row_entries;  ///< sliced rows and hubs, padding included; 0 for grids that gather
  uint64_t edges;       ///< padding included; 0: it gathers
  uint32_t hubs, hub_chunks;
  uint64_t hub_springs;  ///< directed: those of the hubs, among directed_springs
  int guard;  ///< elements that the stencil reads before and behind
  bool constant_forces;
  bool drag;
  bool spring_damping;
  bool triangles;            ///< feels wind, has normals
  int64_t triangle_entries;  ///< sliced rows of triangles, padding included; 0 for grids
  bool sleeps;
  uint32_t moving_pin_blocks;
  uint32_t blocks() const { return (particles + block_size - 1) / block_size; }
};

/// Of the arrays of one cooked collider mesh (state/collider_mesh.h): bytes, or offsets.
struct MeshArrays {
  static constexpr int count = 6;
  size_t of[count];
};

struct WorldShape {
  Precision precision = Precision::float32;
  bool position_form = false;
  Accumulation accumulation = Accumulation::native;  ///< of the cloths that scatter
  double full_scale = 1;                             ///< of fixed8, in largest spring forces
  std::vector<ClothShape> cloths;
  uint32_t colliders[collider_shapes] = {};  ///< by ColliderShape
  uint32_t turning_colliders = 0;
  std::vector<MeshArrays> meshes;  ///< each that a collider uses, once
  bool interpolate = false;        ///< positions before a frame are kept
  bool wind = false;
  bool normals = false;   ///< of meshes: grids need nothing for theirs
  uint32_t motions = 0;   ///< of all cloths, and one for "none" when any pin moves
  uint32_t substeps = 1;  ///< most in a frame: motions are tabulated

  uint32_t colliders_of(ColliderShape shape) const { return colliders[static_cast<int>(shape)]; }
  bool any_grid() const;
  bool any_rows() const;
  bool any_mesh() const;  ///< a mesh or network, whether it gathers or scatters
  bool any_scatter() const;
  uint32_t hubs() const;
  uint32_t hub_chunks() const;
  bool any_per_spring() const;
  bool any_spring_damping() const;
  bool reads_velocities() const;  ///< of neighbours: displacements need two buffers
  bool any_triangle_rows() const;
  bool any_sleeper() const;
  uint32_t all_colliders() const;
  uint32_t survey_groups() const;
  uint64_t moving_pin_blocks() const;
  uint64_t blocks() const;
};

constexpr bool is_grid(KernelKind kind) { return kind <= KernelKind::scatter_grid; }
constexpr bool scatters(KernelKind kind) {
  return kind == KernelKind::scatter_grid || kind == KernelKind::scatter_mesh;
}

}  // namespace weft::plan
