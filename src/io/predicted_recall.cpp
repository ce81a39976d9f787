#include "io/predicted_recall.h"

#include <algorithm>
#include <cmath>

namespace weft::io {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr uint32_t most_diagonal = 64;

/// Bit m: a grid at mark m of an axis (0, 1/2 cell) keeps the pair together along it.
using Marks = std::array<double, 4>;  ///< probability of each set of marks

Marks marks_of(double rho) {
  const double one = 1 - std::min(rho, 1.0), both = 1 - std::min(2 * rho, 1.0);
  return {1 - 2 * one + both, one - both, one - both, both};
}

/// Shifts as bits x, y, z.
constexpr std::array<uint32_t, 8> corner_shifts(uint32_t grids) {
  if (grids == 2) return {0, 7};
  if (grids == 4) return {0, 6, 5, 3};
  return {0, 1, 2, 3, 4, 5, 6, 7};
}

/// `length` marks of `k` on a circle, from `begin`.
uint64_t window_of(uint32_t k, uint32_t length, uint32_t begin) {
  const uint64_t all = k == 64 ? ~uint64_t(0) : (uint64_t(1) << k) - 1;
  const uint64_t window = length == 64 ? ~uint64_t(0) : (uint64_t(1) << length) - 1;
  return begin == 0 ? window : (window << begin | window >> (k - begin)) & all;
}

/// Probability that windows of these lengths, each beginning at any mark, cover all k.
double chance_of_cover(uint32_t k, const std::array<uint32_t, 3>& length) {
  const uint64_t all = window_of(k, k, 0), first = window_of(k, length[0], 0);
  uint64_t covered = 0;
  for (uint32_t s = 0; s < k; ++s) {
    const uint64_t two = first | window_of(k, length[1], s);
    for (uint32_t t = 0; t < k; ++t) covered += (two | window_of(k, length[2], t)) == all;
  }
  return double(covered) / (double(k) * k);
}

}  // namespace

double PairChance::of_corners(const std::array<double, 3>& rho) const {
  const Marks x = marks_of(rho[0]), y = marks_of(rho[1]), z = marks_of(rho[2]);
  const auto shifts = corner_shifts(grids_.grids);
  double chance = 0;
  for (uint32_t state = 0; state < 64; ++state) {
    const uint32_t a = state & 3, b = state >> 2 & 3, c = state >> 4;
    for (uint32_t g = 0; g < grids_.grids; ++g) {
      const uint32_t s = shifts[g];
      if ((a >> (s & 1) & b >> (s >> 1 & 1) & c >> (s >> 2) & 1) == 0) continue;
      chance += x[a] * y[b] * z[c];
      break;
    }
  }
  return chance;
}

double PairChance::of_diagonals(const std::array<double, 3>& rho) {
  std::array<uint32_t, 3> least;
  std::array<double, 3> more;  // probability that the window covers one mark more
  for (size_t i = 0; i < 3; ++i) {
    const double marks = grids_.grids * std::min(rho[i], 1.0);
    least[i] = std::min(uint32_t(marks), grids_.grids);
    more[i] = marks - least[i];
  }
  double missed = 0;
  for (uint32_t state = 0; state < 8; ++state) {
    std::array<uint32_t, 3> length = least;
    double weight = 1;
    for (size_t i = 0; i < 3; ++i) {
      const bool longer = state >> i & 1;
      weight *= longer ? more[i] : 1 - more[i];
      length[i] += longer;
    }
    if (weight > 0) missed += weight * cover(length);
  }
  return 1 - missed;
}

double PairChance::cover(std::array<uint32_t, 3> length) {
  const uint32_t k = grids_.grids;
  if (length[0] + length[1] + length[2] < k) return 0;
  std::sort(length.begin(), length.end());
  if (length[2] >= k) return 1;
  const auto [known, is_new] = cover_.emplace(length, 0.0);
  if (is_new) known->second = chance_of_cover(k, length);
  return known->second;
}

double PairChance::operator()(double3 offset) {
  const std::array<double, 3> rho{std::abs(offset.x) / grids_.cell,
                                  std::abs(offset.y) / grids_.cell,
                                  std::abs(offset.z) / grids_.cell};
  return grids_.shifts == GridShifts::corner ? of_corners(rho) : of_diagonals(rho);
}

double recall_of_uniform_points(const StaggeredGrids& g, double distance) {
  if (g.grids == 1 && distance <= g.cell) {
    const double t = distance / g.cell;
    return 1 - 9.0 / 8 * t + 6 / (5 * pi) * t * t - t * t * t / (8 * pi);
  }
  // Midpoints of the first octant of the ball.
  constexpr int n = 40;
  PairChance chance(g);
  double sum = 0, volume = 0;
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) / n, d = distance * s;
    for (int j = 0; j < n; ++j) {
      const double polar = pi / 2 * (j + 0.5) / n, across = d * std::sin(polar);
      const double weight = s * s * std::sin(polar), z = d * std::cos(polar);
      for (int k = 0; k < n; ++k) {
        const double angle = pi / 2 * (k + 0.5) / n;
        sum += weight * chance({across * std::cos(angle), across * std::sin(angle), z});
        volume += weight;
      }
    }
  }
  return sum / volume;
}

std::optional<double> predicted_recall(const SelfCollisionDesc& desc) {
  if (desc.search == PairSearch::complete) return 1;
  if (desc.window > 0 || desc.grids > most_diagonal) return std::nullopt;
  return recall_of_uniform_points({desc.cell, desc.grids, desc.shifts}, desc.distance);
}

}  // namespace weft::io
