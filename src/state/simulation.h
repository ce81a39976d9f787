// All that a frame works on, as plain views of device memory. Copied into every kernel launch.
#pragma once

#include "state/activity.h"
#include "state/coloured.h"
#include "state/colliders.h"
#include "state/contacts.h"
#include "state/edges.h"
#include "state/forces.h"
#include "state/particles.h"
#include "state/pins.h"
#include "state/springs.h"
#include "state/step.h"
#include "state/tethers.h"
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
  Forces<T> forces;
  Tethers<T> tethers;
  SlicedRows<T> rows;
  Hubs<T> hubs;
  Edges<T> edges;
  ColouredSprings<T> coloured;
  TriangleRows triangles;
  Colliders<T> colliders;
  const ClothActivity<T>* activity;  ///< null: no colliders, and nobody sleeps
  BlockReach<T>* reach;              ///< by block; null without colliders
  NearMemory<T>* near_memory;        ///< by particle; null without collider meshes
  const SurveyRange* survey_ranges;
  Survey<T>* survey;
  int survey_count;
  MovingPins<T> pins;
  Contacts<T> contacts;
  BlockRange ranges[most_block_ranges];
  int range_count;
  bool windy;        ///< some cloth is in wind
  bool places_pins;  ///< the pass at hand does; a GPU's last one alone

  Vec3Array<T> x[3];  ///< x[0] now; x[1] next; x[2]: only in the position form
  Vec3Array<T> d[2];  ///< summed form: d[0] now, d[1] next; equal where no spring reads velocities

  /// Every array of the device memory, with its count: what has none of it is a null view.
  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    const int64_t particles = n.particles;
    array(x[0], particles, n.guard);
    array(x[1], particles, n.guard);
    array(x[2], n.position_form ? particles : 0, n.guard);
    array(d[0], n.position_form ? 0 : particles, n.guard);
    array(d[1], !n.position_form && n.reads_velocities ? particles : 0, n.guard);
    if (!n.reads_velocities) d[1] = d[0];
    array(inverse_mass, particles);
    array.group(block, n);
    array(cloths, n.cloths);
    array(presence, n.grid_particles);
    array.group(rows, n);
    array.group(edges, n);
    array.group(coloured, n);
    array.group(hubs, n);
    array.group(forces, n);
    array.group(tethers, n);
    array.group(triangles, n);
    array(activity, n.uses_activity ? n.cloths : 0);
    array.group(colliders, n);
    array(reach, n.collides ? particles / block_size : 0);
    array(near_memory, n.meets_meshes ? particles : 0);
    array.group(pins, n);
    array.group(contacts, n);
    array(survey_ranges, n.survey_groups);
    array(survey, n.survey_groups);
    array.number(survey_count, n.survey_groups);
    array.number(blocks, particles / block_size);
    array.number(places_pins, n.pin_blocks > 0);
    array.later(ranges, range_count, windy);
  }
};

}  // namespace weft
