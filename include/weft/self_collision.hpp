// Cloth that meets itself, and other cloths.
#pragma once

#include "weft/core.hpp"

namespace weft {
inline namespace v0 {

/// How pairs of near particles are found.
enum class PairSearch : uint8_t {
  complete,  ///< every pair, whatever the distance: groups that are watched, or cells and a list
  staggered  ///< Kipfer, Segal and Westermann 2004, Georgii and Westermann 2005 section 5: pairs
             ///< that share a cell of one of several shifted grids; some are missed
};
/// Where the grids of PairSearch::staggered begin.
enum class GridShifts : uint8_t {
  corner,   ///< half a cell along the axes of 1 {000}, 2 {000,111}, 4 {000,011,101,110}, 8 all
  diagonal  ///< grid j of k: j/k of a cell along (1,1,1)
};

/// Self-collision of a world: two free or pinned particles touch when they are nearer than
/// `distance` (strictly) and may meet (ClothSettings::collides_itself, collides_others,
/// collision_layers). A pair of one cloth whose rest shape has them nearer than `distance` is left
/// out: springs and contact would fight (World::contacts counts these). Touching particles part
/// along their line, shared by their inverse masses; the approach of their displacements is
/// removed, and Coulomb friction holds the rest, four times in a substep where anything touches.
/// Momentum stays. An overlap gives no speed but what the weight of a heap may need (at most 160
/// times what gravity adds in a substep); of that the passes take back what nothing presses on.
struct SelfCollisionDesc {
  PairSearch search = PairSearch::complete;
  double distance = 0.01;  ///< m, > 0; ClothSettings::collision_distance says otherwise of a cloth
  double friction = 0;     ///< coefficient of Coulomb friction, >= 0
  double cell = 0.02;      ///< m, > 0: edge of a cell of PairSearch::staggered
  /// Grids of PairSearch::staggered: 1, 2, 4 or 8 by corner, 1 to 64 by diagonal.
  uint32_t grids = 8;
  GridShifts shifts = GridShifts::corner;
  /// PairSearch::staggered: a particle looks at this many before and behind it in its cell; 0: all.
  uint32_t window = 0;
  /// PairSearch::complete: below 0: groups of particles are watched where the back end can, else a
  /// list of near pairs is made, with a skin chosen as the cloths move. Else such a list: m, by how
  /// much more than `distance` its pairs may be apart; 0: made anew in every substep. Bits do not
  /// depend on it, time does.
  double skin = -1;
};

/// Self-collision at the present positions.
struct ContactCounts {
  uint64_t touching = 0;  ///< pairs that touch
  uint64_t excluded = 0;  ///< pairs of one cloth that never do: their rest distance is too short
  uint64_t listed = 0;    ///< entries of the last list: every pair twice, and filling
  uint64_t lists = 0;     ///< lists (or pairs of groups) made since the world was
};

/// Two vertices nearer than their distance; a is the cloth that was created first, and within one
/// cloth the lower vertex.
struct NearPair {
  ClothId cloth_a, cloth_b;
  uint32_t vertex_a, vertex_b;
};

}  // namespace v0
}  // namespace weft
