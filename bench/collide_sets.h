// Sets of points whose near pairs are counted, and searches through them.
#pragma once

#include "weft/weft.hpp"

#include <string>
#include <vector>

#include "io/recall.h"

namespace weft::bench {

/// Uniform in the unit cube.
std::vector<double3> uniform_points(uint32_t count, uint64_t seed);
/// A unit sheet of n x n, folded without stretching: what lies behind each of `folds` random
/// planes, which pass its middle by at most 0.1 m, is mirrored in it. Then each point is moved by
/// up to `jitter` along each axis.
std::vector<double3> crumpled_sheet(uint32_t n, uint32_t folds, double jitter, uint64_t seed);
/// All of them moved by one random offset below a metre.
std::vector<double3> moved(std::vector<double3>, uint64_t seed);

/// How many points share the cell of a point, itself included, on average over the points.
double points_per_cell(const std::vector<double3>&, double cell);

/// "staggered, 4 corner grids, h = 2 r, window 8", with h over r = cell over distance.
std::string name_of(const SelfCollisionDesc&);

/// Free points that touch when they are near, in a world on one thread.
class Cloud {
 public:
  Cloud(const std::vector<double3>& points, const SelfCollisionDesc&);

  struct Search {
    io::Recall recall;
    double seconds;  ///< of near_pairs, the best of three
  };
  Search search();
  /// Wall time of one substep that makes its list or its grids, and parts what touches.
  double step();

 private:
  Context context_;
  World world_;
  ClothId cloth_;
  io::MeetingCloth points_;
};

}  // namespace weft::bench
