// Listing 22.1 of Fratarcangeli 2011 taken by the letter, one erratum at a time: tests show that it
// gives other numbers than the meaning of its text, so that they could not pass with it.
#pragma once

#include "reference/grid.h"

namespace reference {

/// Step 5.5 with its sign, -1, repels when it is stretched; it means +1. Anchor at 0, x on a line,
/// started at rest.
inline double signed_spring(double sign, double stiffness, double mass, double rest, double x0,
                            double dt, int steps) {
  const auto increment = [&](double x) {
    const double to_anchor = 0 - x, l = std::abs(to_anchor);
    return sign * (to_anchor / l) * (l - rest) * stiffness / mass * dt * dt;
  };
  double x = x0, previous = x0 + increment(x0) / 2;
  for (int n = 0; n < steps; ++n) {
    const double next = 2 * x - previous + increment(x);
    previous = x;
    x = next;
  }
  return x;
}

/// Steps 4 and 6: gravity starts the *force* and is divided by the mass. Drop after `steps`.
inline double literal_gravity_drop(double mass, double dt, int steps) {
  double y = 0, previous = 0.5 * (-9.81 / mass) * dt * dt;
  for (int n = 0; n < steps; ++n) {
    const double next = 2 * y - previous + (-9.81 / mass) * dt * dt;
    previous = y;
    y = next;
  }
  return -y;
}

/// Step 5.5 subtracts b*vel once per neighbour. Terminal velocity of a vertex with `valence`.
inline double literal_terminal_velocity(double weight, double b, int valence) {
  return weight / (b * valence);
}

/// Step 5.3: rest length |offset|/n, where the initial spacing is 1/(n-1).
inline std::vector<Spring> literal_rest_lengths(uint32_t n, double stiffness) {
  std::vector<Spring> springs;
  const std::vector<Vec> x = grid_positions(n, n);
  springs = grid_springs_at_rest(n, n, seed12(), stiffness, x);
  for (Spring& s : springs) s.rest *= double(n - 1) / double(n);
  return springs;
}

struct LiteralNeighbours {
  int64_t count = 0, wrapped = 0, outside_array = 0;
};

/// Step 5 tests (row + x, column + y) and step 5.1 reads (row + y) n + column + x.
inline LiteralNeighbours literal_neighbours(int n) {
  LiteralNeighbours found;
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c)
      for (const auto& [one, other] : seed12())
        for (int sign : {1, -1}) {
          const int x = sign * one, y = sign * other;
          if (r + x < 0 || r + x >= n || c + y < 0 || c + y >= n) continue;
          ++found.count;
          const int row = r + y, column = c + x, index = row * n + column;
          if (index < 0 || index >= n * n)
            ++found.outside_array;
          else if (row < 0 || row >= n || column < 0 || column >= n)
            ++found.wrapped;
        }
  return found;
}

}  // namespace reference
