// The reference of XPBD: springs one after the other as equations (18) and (26) of Macklin, Mueller
// and Chentanez 2016 write them, one iteration a substep, in double precision.
#pragma once

#include "reference/grid.h"
#include "reference/verlet.h"

#include <algorithm>

namespace reference {

/// A spring, and whether it only pulls.
struct Link : Spring {
  bool pulls_only = false;
};

/// In the order of docs/solvers.md: those two apart, the diagonals, the sides; of each direction,
/// ascending, first those that begin in even rows (columns) and then those in odd ones, where a row
/// is as high as the springs are.
inline std::vector<Link> links_of_grid(int rows, int columns, Offsets offsets, double stiffness,
                                       double width = 1, double height = 1,
                                       const std::vector<int>& ladder = {}) {
  struct Direction {
    int dr, dc, stride;
  };
  std::sort(offsets.begin(), offsets.end());
  std::vector<Direction> order;
  const auto reach = [](std::pair<int, int> o) {
    return std::abs(o.first) + 10 * std::abs(o.second);
  };
  const auto add = [&](auto wanted, int stride) {
    for (const auto& o : offsets) {
      if (wanted(reach(o))) order.push_back({o.first * stride, o.second * stride, stride});
    }
  };
  const auto side = [](int r) { return r == 1 || r == 10; };
  for (const int stride : ladder) add(side, stride);
  add([](int r) { return r == 2 || r == 20 || r == 22; }, 1);
  add([](int r) { return r == 11; }, 1);
  add(side, 1);
  const std::vector<Vec> x = grid_positions(uint32_t(rows), uint32_t(columns), width, height);
  std::vector<Link> links;
  for (const Direction& d : order) {
    for (int parity = 0; parity < 2; ++parity) {
      for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
          if (r + d.dr >= rows || c + d.dc < 0 || c + d.dc >= columns) continue;
          if ((d.dr > 0 ? r / d.dr : c / d.dc) % 2 != parity) continue;
          Link link;
          link.a = uint32_t(r * columns + c);
          link.b = uint32_t((r + d.dr) * columns + c + d.dc);
          link.stiffness = stiffness / d.stride;
          link.rest = length(x[link.b] - x[link.a]);
          link.pulls_only = d.stride > 1;
          links.push_back(link);
        }
      }
    }
  }
  return links;
}

class Xpbd {
 public:
  /// `system.springs` is not looked at: `links` are the springs, in the order they are moved in.
  Xpbd(System system, std::vector<Link> links, double h)
      : system_(std::move(system)), links_(std::move(links)), h_(h), x_(system_.positions) {
    v_ = system_.velocities;
    v_.resize(x_.size());
    w_.resize(x_.size());
    for (size_t i = 0; i < w_.size(); ++i) w_[i] = 1 / system_.masses[i];
    for (const uint32_t p : system_.pins) w_[p] = 0;
  }

  void steps(int count) {
    for (int s = 0; s < count; ++s) step();
  }
  const std::vector<Vec>& positions() const { return x_; }
  const std::vector<Vec>& velocities() const { return v_; }

 private:
  void step() {
    ++n_;
    std::vector<Vec> y = x_;
    for (size_t i = 0; i < y.size(); ++i) {
      const double g = 0.5 * system_.drag * h_ * w_[i];  // drag at the middle of the velocities
      const Vec v = (1 / (1 + g)) * ((1 - g) * v_[i] + h_ * system_.gravity);
      if (w_[i] > 0) y[i] += h_ * v;
    }
    for (const uint32_t p : system_.pins) {
      if (system_.pin_motion) y[p] = system_.pin_motion(p, n_ * h_);
    }
    for (const Link& link : links_) move(link, y);
    for (size_t i = 0; i < y.size(); ++i) v_[i] = (1 / h_) * (y[i] - x_[i]);
    x_ = y;
  }

  void move(const Link& link, std::vector<Vec>& y) const {
    const Vec to = y[link.b] - y[link.a], was = x_[link.b] - x_[link.a];
    const double l = length(to), w = w_[link.a] + w_[link.b];
    if (l == 0 || w == 0 || link.stiffness == 0) return;
    if (link.pulls_only && l <= link.rest) return;
    const Vec n = (1 / l) * to;
    const double alpha = 1 / (link.stiffness * h_ * h_);
    const double beta = link.pulls_only ? 0 : h_ * h_ * system_.spring_damping;
    const double gamma = alpha * beta / h_;
    const double lambda = (-(l - link.rest) - gamma * dot(n, to - was)) / ((1 + gamma) * w + alpha);
    y[link.a] -= (w_[link.a] * lambda) * n;
    y[link.b] += (w_[link.b] * lambda) * n;
  }

  System system_;
  std::vector<Link> links_;
  double h_;
  int n_ = 0;
  std::vector<Vec> x_, v_;
  std::vector<double> w_;
};

}  // namespace reference
