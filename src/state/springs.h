// Springs of meshes and networks: sliced rows (SELL-32), and chunks for what is too long for them.
//
// The block of 32 particles is the slice. Entry (k, lane) of a slice stands at start + k*32 + lane
// and is the lane's k-th neighbour in ascending caller index, so sums do not depend on storage
// order. Short rows are filled with the particle itself, which pulls nothing.
//
// A hub, a vertex of more than `hub_valence` springs, has an empty row. Its entries lie behind the
// slices of all cloths, also in ascending caller index, cut into chunks of 1024 that a block of 32
// lanes sums as kernels/reduce.h does: memory and time follow the number of springs, not the
// largest valence.
#pragma once

#include "base/vec3.h"
#include "state/counts.h"

namespace weft {

template <class T>
struct SlicedRows {
  const int64_t* start;      ///< per slice and one more: first entry; width = difference / 32
  const int32_t* neighbour;  ///< element of the particle at the other end
  const T* rest;             ///< m
  const T* stiffness;        ///< N/m; null where the cloth has one for all
  int first_block;           ///< block of slice 0

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    array(start, n.row_slices > 0 ? n.row_slices + 1 : 0);
    const int64_t entries = n.row_entries + n.hub_entries;
    array(neighbour, entries);
    array(rest, entries);
    array(stiffness, n.own_stiffness > 0 ? entries : 0);
    array.number(first_block, n.first_row_block);
  }
};

/// A vertex with more than hub_valence springs, and its chunks.
struct Hub {
  int32_t particle;
  int32_t first_chunk, end_chunk;
};
/// Entries [first, end) of a hub's row, filled up to whole blocks.
struct HubChunk {
  int64_t first, end;
  int32_t particle;
};

/// Hubs of all cloths, ascending by particle.
template <class T>
struct Hubs {
  const int32_t* of_block;  ///< per block: its first hub, or `count`; null: there are no hubs
  const Hub* hub;
  const HubChunk* chunk;
  Vec3<T>* force;    ///< by chunk
  Vec3<T>* damping;  ///< by chunk; null where no spring is damped
  int count, chunks;

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    array(of_block, n.hubs > 0 ? n.particles / block_size : 0);
    array(hub, n.hubs);
    array(chunk, n.hub_chunks);
    array(force, n.hub_chunks);
    array(damping, n.damped_hubs ? n.hub_chunks : 0);
    array.number(count, n.hubs);
    array.number(chunks, n.hub_chunks);
  }
};

}  // namespace weft
