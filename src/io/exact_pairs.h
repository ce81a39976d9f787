// Which particles are nearer than their distance, found without cells: what every search of cells
// is measured by.
#pragma once

#include "weft/core.hpp"

#include <compare>
#include <cstdint>
#include <functional>
#include <vector>

namespace weft::io {

/// A cloth as a cloud of points.
struct MeetingCloth {
  std::vector<double3> positions;  ///< m, finite
  double distance = 0;             ///< m, > 0; a pair of two cloths takes the mean of theirs
  bool itself = true;              ///< its points meet each other
  bool others = true;              ///< they meet points of other cloths that say so too
  uint32_t layers = ~0u;           ///< two cloths meet where they share a bit
};

/// The distance of pairs of two cloths, or of one with itself; 0 where they do not meet.
double meeting_distance(const MeetingCloth&, const MeetingCloth&, bool same);
/// (dx dx + dy dy) + dz dz < distance distance, strictly, in double.
bool are_nearer(double3 a, double3 b, double distance);

/// cloth_a <= cloth_b; within one cloth vertex_a < vertex_b.
struct MeetingPair {
  uint32_t cloth_a, vertex_a, cloth_b, vertex_b;
  friend auto operator<=>(const MeetingPair&, const MeetingPair&) = default;
};

/// Pairs nearer than their distance, each counted once. A k-d tree for each cloth, two of which are
/// descended together: exact for any distance, place and crowd. Coincident points take no time.
/// Errors: std::invalid_argument for a position that is not finite, naming it.
uint64_t count_near_pairs(const std::vector<MeetingCloth>&);
/// The same pairs one by one, in no order.
void each_near_pair(const std::vector<MeetingCloth>&,
                    const std::function<void(const MeetingPair&)>&);
/// Ascending.
std::vector<MeetingPair> list_near_pairs(const std::vector<MeetingCloth>&);

}  // namespace weft::io
