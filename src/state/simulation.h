// All that a frame works on, as plain views of device memory. Copied into every kernel launch.
#pragma once

#include "state/activity.h"
#include "state/colliders.h"
#include "state/edges.h"
#include "state/particles.h"
#include "state/pins.h"
#include "state/springs.h"
#include "state/step.h"
#include "state/triangles.h"

namespace weft {

/// Which compiled kernel advances a range of blocks: rows of step/variants.h.
/// Grids come first, then what scatters, then meshes and networks.
enum class KernelKind : int32_t {
  seed12,
  classic12,
  quad4,
  tri6,
  scatter_grid,
  scatter_mesh,
  mesh_uniform,
  mesh_per_spring
};

/// A range of blocks that one launch advances.
struct BlockRange {
  KernelKind kind;
  int first, count;
};
constexpr int most_block_ranges = 8;

template <class T>
struct Simulation {
  int blocks;
  const ClothParams<T>* cloths;
  Blocks block;
  const uint16_t* presence;  ///< grids: bit k = neighbour k exists; read in border blocks only
  const T* inverse_mass;     ///< 0: pinned, or padding
  Vec3Array<T> force;        ///< constant forces of the cloths that have any
  SlicedRows<T> rows;
  Hubs<T> hubs;
  Edges<T> edges;
  TriangleRows triangles;
  Colliders<T> colliders;
  const ClothActivity<T>* activity;  ///< null: no colliders, and nobody sleeps
  BlockReach<T>* reach;              ///< by block; null without colliders
  NearMemory<T>* near_memory;        ///< by particle; null without collider meshes
  const SurveyRange* survey_ranges;
  Survey<T>* survey;
  int survey_count;
  MovingPins<T> pins;
  BlockRange ranges[most_block_ranges];
  int range_count;
  bool windy;  ///< some cloth is in wind

  Vec3Array<T> x[3];  ///< x[0] now; x[1] next; x[2]: only in the position form
  Vec3Array<T> d[2];  ///< summed form: d[0] now, d[1] next; equal where no spring reads velocities
};

}  // namespace weft
