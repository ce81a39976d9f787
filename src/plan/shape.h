// What a world's cloths need, in numbers: all that a plan depends on.
#pragma once

#include "base/memory_host.h"
#include "state/simulation.h"
#include "weft/core.hpp"

namespace weft::plan {

/// One cloth, in arena order.
struct ClothShape {
  KernelKind kind;
  uint32_t particles;
  uint64_t directed_springs;
  int64_t
      row_entries;  ///< sliced rows and hubs, padding included; 0 for grids that gather, atomics
  uint64_t edges;   ///< padding included; 0: it gathers
  int64_t hub_entries;            ///< of the row_entries: those of hubs
  uint32_t hubs, hub_chunks;      ///< none where atomics add up
  uint32_t colours = 0;           ///< XPBD: of its springs; 0: they are forces
  uint32_t spring_blocks = 0;     ///< of at most 32 springs of a colour
  uint64_t coloured_springs = 0;  ///< of meshes and networks, padding included
  uint64_t ladder_springs = 0;    ///< of grids: long ones
  uint64_t hub_springs;           ///< directed: those of the hubs, among directed_springs
  int guard;                      ///< elements that the stencil reads before and behind
  bool drag;
  bool spring_damping;
  bool triangles;            ///< feels wind, has normals
  int64_t triangle_entries;  ///< sliced rows of triangles, padding included; 0 for grids
  bool sleeps;
  uint32_t moving_pin_blocks, motions;
  uint32_t parts;  ///< bit k: it has Part k
  uint32_t blocks() const { return (particles + block_size - 1) / block_size; }
  bool has(Part part) const { return (parts >> static_cast<int>(part) & 1u) != 0; }
};

/// What a part does to the pass that it is a stage of.
struct PartCost {
  const char* name;
  double bytes, flops;  ///< per particle of a cloth that has it
};

struct WorldShape {
  Precision precision = Precision::float32;
  bool position_form = false;
  bool projects = false;                             ///< XPBD: springs are constraints
  Accumulation accumulation = Accumulation::native;  ///< of the cloths that scatter
  double full_scale = 1;                             ///< of fixed8, in largest spring forces
  Vector<ClothShape> cloths;
  PartCost parts[part_count] = {};
  uint32_t colliders[collider_shapes] = {};  ///< by ColliderShape
  uint32_t turning_colliders = 0;
  Vector<GridCounts> meshes;    ///< each that a collider uses, once
  bool interpolate = false;     ///< positions before a frame are kept
  uint32_t contact_grids = 0;   ///< of self-collision: 0 none, 1 complete, else staggered or
  bool staggered = false;       ///< staggered with one
  bool contact_groups = false;  ///< looked for among groups of particles: on a host
  bool wind = false;
  bool normals = false;   ///< of meshes: grids need nothing for theirs
  uint32_t substeps = 1;  ///< most in a frame: motions are tabulated

  size_t scalar() const { return precision == Precision::float64 ? sizeof(double) : sizeof(float); }
};

constexpr bool is_grid(KernelKind kind) { return kind <= KernelKind::scatter_grid; }
constexpr bool scatters(KernelKind kind) {
  return kind == KernelKind::scatter_grid || kind == KernelKind::scatter_mesh;
}

/// Where the elements of each cloth begin in the arrays; one more entry than cloths: the whole.
Vector<ClothCounts> places_of(const WorldShape&);
Counts counts_of(const WorldShape&);

}  // namespace weft::plan
