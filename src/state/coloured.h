// Springs that are moved one colour after the other: no two of a colour share a particle, so the
// order within one changes no bit (kernels/project_springs.h).
#pragma once

#include "base/view.h"
#include "state/counts.h"

namespace weft {

/// At most 32 springs of one colour of one cloth.
struct SpringBlock {
  int32_t cloth;
  int32_t first;   ///< grids: element of the first one's end a; listed: its place in the list
  int32_t shift;   ///< grids: from end a to end b; 0: listed
  uint8_t slot;    ///< grids: stencil neighbour, whose stiffness and rest length they have
  uint8_t step;    ///< grids: elements from one to the next; 4: two springs, from i and from i + 1
  uint8_t count;   ///< of lanes
  uint8_t stride;  ///< above 1: as long as so many springs in a row, and only pulls
};

/// All colours of a large grid in one pass over its rows: colour c is as many rows behind the first
/// one as every spring that comes before one of its own needs to be done. `rows` 0: a small cloth.
struct ColourSweep {
  int32_t rows, colours;
  const int32_t* lag;        ///< by colour
  const int32_t* row_start;  ///< by colour and row, each colour one more than rows: first block
};

/// Where the blocks of a colour, and of a cloth within it, begin. For the host that orders the
/// passes, in memory of its own.
struct ColourTable {
  int32_t colours, cloths;
  const int32_t* start;      ///< by colour, and one more
  const int32_t* of;         ///< by colour and cloth, each colour one more than cloths
  const int32_t* work;       ///< by cloth, and one more: blocks before it
  const ColourSweep* sweep;  ///< by cloth
  int32_t most_of_a_cloth;   ///< blocks
};

/// Springs of all cloths by colour, where they are constraints (XPBD).
template <class T>
struct ColouredSprings {
  const SpringBlock* block;  ///< by colour, then by cloth
  // Of meshes and networks, by colour, each colour filled up to whole blocks of 32.
  const int32_t *a, *b;  ///< elements of the ends
  const T *rest, *stiffness;
  int32_t projects;  ///< 1: springs are constraints, and not forces
  ColourTable table;

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    array(block, n.spring_blocks);
    array(a, n.coloured_springs);
    array(b, n.coloured_springs);
    array(rest, n.coloured_springs);
    array(stiffness, n.coloured_springs);
    array.number(projects, n.projects ? 1 : 0);
    array.later(table);
  }
};

}  // namespace weft
