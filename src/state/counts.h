// How many elements the arrays of a world have. The state structs list their arrays with these
// (`arrays`), and whoever needs sizes, views or the image to write walks the lists
// (plan/cutter.h).
#pragma once

#include "state/stages.h"

namespace weft {

/// Of the arrays that grow from cloth to cloth. Added up over the cloths before one, they are where
/// its own elements begin.
struct ClothCounts {
  int64_t cloths;
  int64_t particles;       ///< filled up to whole blocks
  int64_t grid_particles;  ///< of them in grids
  int64_t row_slices, row_entries;
  int64_t hub_entries;    ///< of hubs, behind all slices: a slice ends where the next one begins
  int64_t own_stiffness;  ///< of the entries: in cloths whose springs differ
  int64_t scatter_slices, edges, incident;
  int64_t hub_incident;  ///< the same of cloths that scatter
  int64_t hubs, hub_chunks;
  int64_t spring_blocks;        ///< of coloured springs
  int64_t coloured_springs;     ///< of them, those in a list, each colour filled up to whole blocks
  int64_t fan_slices, corners;  ///< of triangles: of all meshes, whether they gather or scatter
  int64_t pin_blocks, motions;  ///< the first motion is "none"
  int64_t survey_groups;
  int64_t part[part_count];  ///< particles of the cloths that have it
};

/// Of all arrays of a world.
struct Counts : ClothCounts {
  int64_t guard;  ///< elements that a stencil reads before the first particle and behind the last
  int64_t first_row_block, first_scatter_block, first_mesh_block;
  int64_t colliders[6], all_colliders;  ///< by ColliderShape, and together
  int64_t turns;                        ///< columns of turning colliders
  int64_t substeps;                     ///< most in a frame
  bool position_form;
  bool reads_velocities;  ///< of neighbours: displacements need two buffers
  bool keeps_before;      ///< positions before a frame
  bool projects;          ///< springs are constraints: state/coloured.h
  bool damped_edges, damped_hubs;
  bool uses_activity, collides, meets_meshes;
  int64_t contact_grids;  ///< that particles are sorted into to find who is near; 0: nobody looks
  int64_t key_bits;       ///< of a cell's key
  bool staggered;         ///< by several grids, without a list that outlives a substep
  bool contact_groups;    ///< groups of particles are watched
  int32_t accumulation;   ///< Accumulation
  double full_scale;
};

}  // namespace weft
