// The springs of a fabric in colours: no two springs of a colour share a vertex.
#pragma once

#include "scene/edges.h"

namespace weft::scene {

/// At most 32 springs of a colour: state/coloured.h, SpringBlock.
struct ColourBlock {
  int32_t first, shift;
  uint8_t slot, step, count, stride;
};

/// Long springs of a grid at these strides, largest first; 0 ends the list.
struct Ladder {
  static constexpr int most = 6;
  uint8_t stride[most] = {};
};
/// What pays: long springs shorten the way through a large grid. Strides from 4 to 8 from 64 rows
/// or columns on, to 16 from 192, to 32 from 448 (`weft bench stretch`).
Ladder usual_ladder(const CookedFabric&);

struct Colours {
  Vector<ColourBlock> blocks;  ///< by colour, in the order that they are moved in
  Vector<uint32_t> start;      ///< by colour, and one more: its first block
  /// Of meshes and networks: by colour, each filled up to blocks of 32 with springs that join a
  /// vertex to itself.
  Vector<Edge> springs;
  Vector<int32_t> rows_up;  ///< of grids: by colour, rows from end a to end b
  uint8_t longest = 1;      ///< stride
  uint32_t most_at = 0;  ///< a vertex of the most springs, caller index, where there are too many
  uint32_t valence = 0;  ///< and its springs

  uint32_t count() const { return static_cast<uint32_t>(start.size()) - 1; }
};
/// Of its springs, the long ones.
uint64_t ladder_springs(const Colours&);
/// A vertex of more springs needs more colours than are worth it.
constexpr uint32_t most_colours = 256;

/// Grids: two colours for each direction of the stencil, bend first, then shear, then stretch, so
/// that what stretches most is moved last. Others: each spring in the storage order of its ends
/// takes the first colour that is free at both. Too many springs at a vertex: `valence` is not 0.
Colours colour_springs(const CookedFabric&, const Ladder&);

}  // namespace weft::scene
