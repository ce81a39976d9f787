// Springs that are evaluated once each and then scattered to their two ends: Georgii and Westermann
// 2005, section 4.2 (edge-centric approach).
#pragma once

#include "base/view.h"
#include "state/counts.h"

namespace weft {

/// How the forces of the springs of a vertex are added up (kernels/accumulate.h).
enum class Accumulation : int32_t {
  native,   ///< over its springs in ascending neighbour index: the bits of the gather
  atomic,   ///< by floating-point atomics, in any order
  fixed64,  ///< by 64-bit integer atomics, whose order does not matter
  // To be measured (kernels/measured):
  float16,      ///< over its springs, the sum rounded to 11 significant bits after each
  float24,      ///< to 17: the fragment units of 2005
  float24_all,  ///< the same, and positions and forces are computed with 17 bits too
  fixed8        ///< to 8 bits, saturating; full scale is the largest spring force
};

/// The formats that exist to be measured: their sums are passes of their own.
WEFT_HD constexpr bool is_measured(Accumulation a) {
  return a != Accumulation::native && a != Accumulation::atomic && a != Accumulation::fixed64;
}
WEFT_HD constexpr bool uses_atomics(Accumulation a) {
  return a == Accumulation::atomic || a == Accumulation::fixed64;
}

/// The springs of every cloth that scatters, each cloth's filled up to whole blocks of 32 (at least
/// one entry of them) with springs that join its first particle to itself.
template <class T>
struct Edges {
  int blocks;            ///< of springs; 0: no cloth scatters
  const int32_t* cloth;  ///< by block of springs
  const int32_t *a, *b;  ///< elements of the ends; a < b
  const T *rest, *stiffness;
  Vec3Array<T> force;    ///< on a; null where atomics take it to its particle
  Vec3Array<T> damping;  ///< on a, along the spring; null: none, or part of `force`

  // By particle: sliced rows as in state/springs.h, of springs instead of neighbours.
  const int64_t* start;
  const int32_t* incident;  ///< e: the particle is end a of spring e; ~e: it is end b
  int first_block;          ///< of the particles of slice 0
  int particle_blocks;

  Accumulation accumulation;
  Vec3Array<T> total;            ///< by particle from first_block on; null in native
  unsigned long long* fixed;     ///< the same as x, y, z by turns in fixed64, two's complement
  unsigned long long* overflow;  ///< fixed64: substep << 32 | spring of the first, or no_overflow

  // Of kernels/measured:
  unsigned long long* largest;  ///< fixed8: bits of the largest force of a spring, as double
  double full_scale;            ///< fixed8: in largest spring forces

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    const auto mode = static_cast<Accumulation>(n.accumulation);
    const bool in_order = !uses_atomics(mode), whole = mode == Accumulation::fixed64;
    const int64_t particles = n.scatter_slices * block_size;
    array.number(blocks, n.edges / block_size);
    array(cloth, n.edges / block_size);
    array(a, n.edges);
    array(b, n.edges);
    array(rest, n.edges);
    array(stiffness, n.edges);
    array(force, in_order ? n.edges : 0);
    array(damping, n.damped_edges && mode == Accumulation::native ? n.edges : 0);
    array(start, in_order && particles > 0 ? n.scatter_slices + 1 : 0);
    array(incident, n.incident + n.hub_incident);
    array.number(first_block, n.first_scatter_block);
    array.number(particle_blocks, n.scatter_slices);
    array.number(accumulation, mode);
    array(total, whole || mode == Accumulation::native ? 0 : particles);
    array(fixed, whole ? 3 * particles : 0);
    array(overflow, whole && particles > 0 ? 1 : 0);
    array(largest, mode == Accumulation::fixed8 && particles > 0 ? 1 : 0);
    array.number(full_scale, n.full_scale);
  }
};

constexpr unsigned long long no_overflow = ~0ull;

}  // namespace weft
