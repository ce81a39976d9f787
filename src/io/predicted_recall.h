// What share of the near pairs staggered grids find, from geometry alone.
//
// A pair whose ends are rho cells apart along an axis is separated there by a grid with probability
// min(rho, 1), whatever the place of the grid. One grid finds it with the product of 1 - rho over
// the axes. Several grids are not independent. On a circle of one cell's length, on which the
// shifted grids are k equal steps, an axis separates the pair in the grids of a window of length
// rho that begins anywhere:
//
//      0        1/4       1/2       3/4        1      four diagonal grids: rho = 0.4 covers one
//      |---------|---------|---------|---------|      or two of the four marks; grids that no axis
//            [______rho______)                        covers find the pair
//
// Corner grids have two marks per axis, 0 and 1/2, and a grid chooses one of each axis. Three axes
// cover independently, so the share follows by counting, without approximation.
#pragma once

#include "weft/self_collision.hpp"

#include <array>
#include <map>
#include <optional>

namespace weft::io {

/// The grids of PairSearch::staggered, each cell searched in full.
struct StaggeredGrids {
  double cell = 0.02;  ///< m, > 0
  uint32_t grids = 8;  ///< 1, 2, 4 or 8 by corner, 1 to 64 by diagonal
  GridShifts shifts = GridShifts::corner;
};

/// Probability that grids at a random place find a pair. Diagonal ones remember what they count.
class PairChance {
 public:
  explicit PairChance(const StaggeredGrids& grids) : grids_(grids) {}

  /// Of a pair whose ends are `offset` (m) apart.
  double operator()(double3 offset);

 private:
  double of_corners(const std::array<double, 3>& rho) const;
  double of_diagonals(const std::array<double, 3>& rho);
  double cover(std::array<uint32_t, 3> length);

  StaggeredGrids grids_;
  std::map<std::array<uint32_t, 3>, double> cover_;  ///< by marks that each axis covers
};

/// The mean over pairs nearer than `distance` (m, > 0) in a uniform cloud of points: over every
/// direction, and over distances as they fill a ball. Of one grid with t = distance/cell <= 1 it is
/// 1 - 9/8 t + 6/(5 pi) t^2 - t^3/(8 pi); of others it is summed up to about 1e-4.
double recall_of_uniform_points(const StaggeredGrids&, double distance);

/// The same of a world's search: 1 of PairSearch::complete; none with a window, which finds fewer
/// the more points share a cell.
std::optional<double> predicted_recall(const SelfCollisionDesc&);

}  // namespace weft::io
