// Particles of all cloths: one arena, each cloth padded to whole blocks, with guard bands at both
// ends that make every stencil load legal.
//
//   | guard | cloth 0 ........ pad | cloth 1 ... pad | ... | guard |
//           ^ element 0, block 0
#pragma once

#include "state/colliders.h"

namespace weft {

/// What one substep reads and writes. `d` is the displacement of the last substep in the summed
/// form and the previous position in the position form.
template <class T>
struct ParticleBuffers {
  Vec3Array<T> x_in, d_in, x_out, d_out;
};

/// Everything that is equal for all particles of a cloth.
template <class T>
struct ClothParams {
  int first, end;              ///< elements of its particles
  int columns;                 ///< grids: elements from row to row
  T stiffness[12], rest[12];   ///< grids: by stencil neighbour; others: [0] when uniform
  T drag;                      ///< N s/m
  T spring_damping;            ///< N s/m
  int drag_model;              ///< state/step.h, Drag
  int starting;                ///< 1: the start pass is its first
  int in_wind;                 ///< it has triangles and there is wind
  T fixed_scale, fixed_limit;  ///< fixed64: units of 1 N; most units of one spring
  T half_scale;                ///< float16: what forces are multiplied by, a power of two
  int axial[4];  ///< grids: presence bits of the neighbours +column, +row, -column, -row
  int collider_first[collider_shapes], collider_count[collider_shapes];
  int part[part_count];  ///< by Part: element of its first entry minus `first`; no_part: it has
                         ///< none
  T part_number[part_count];  ///< by Part: what it says (api/arena/parts.h)
};

constexpr int no_part = INT32_MIN;

/// Per block: which cloth it belongs to, and what is special about it.
struct Blocks {
  const int32_t* cloth;  ///< index into the cloth parameters
  const uint8_t* inner;  ///< grids: 1 where every particle has every neighbour

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    array(cloth, n.particles / block_size);
    array(inner, n.grid_particles / block_size);
  }
};

}  // namespace weft
