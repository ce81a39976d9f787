// The reference simulator: the papers' x' = 2x - x_prev + a dt^2 in double precision, with drag,
// spring damping and pins as the scene format states them.
#pragma once

#include "reference/springs.h"

#include <functional>
#include <utility>

namespace reference {

struct System {
  std::vector<Vec> positions;
  std::vector<Vec> velocities;  // empty: at rest
  std::vector<double> masses;   // one per vertex
  std::vector<uint32_t> pins;
  std::vector<Spring> springs;
  Vec gravity;
  double drag = 0;
  bool central_drag = true;
  double spring_damping = 0;
  bool taylor_start = true;
  /// Where pin `vertex` is at `time`; empty: it stays.
  std::function<Vec(uint32_t vertex, double time)> pin_motion;
};

class Verlet {
 public:
  Verlet(System system, double dt)
      : system_(std::move(system)), dt_(dt), x_(system_.positions), pinned_(x_.size(), false) {
    for (uint32_t p : system_.pins) pinned_[p] = true;
    std::vector<Vec> v = system_.velocities;
    v.resize(x_.size());
    const std::vector<Vec> a = accelerations(v, true);
    previous_ = x_;
    for (size_t i = 0; i < x_.size(); ++i) {
      previous_[i] -= dt * v[i];
      if (system_.taylor_start) previous_[i] += (0.5 * dt * dt) * a[i];
      if (pinned_[i]) previous_[i] = pin(uint32_t(i), -dt);
    }
  }

  void step() {
    const std::vector<Vec> next = following();
    previous_ = x_;
    x_ = next;
    ++n_;
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }

  const std::vector<Vec>& positions() const { return x_; }
  /// (x_(n+1) - x_(n-1))/2dt
  Vec velocity(size_t i) const { return (0.5 / dt_) * (following()[i] - previous_[i]); }
  /// Springs and gravity by mass; pins: 0.
  std::vector<Vec> accelerations() const { return accelerations({}, false); }

 private:
  Vec pin(uint32_t i, double time) const {
    return system_.pin_motion ? system_.pin_motion(i, time) : system_.positions[i];
  }

  std::vector<Vec> accelerations(const std::vector<Vec>& v, bool with_drag) const {
    std::vector<Vec> f(x_.size());
    add_spring_forces(system_.springs, x_, f);
    if (system_.spring_damping > 0 && !v.empty())
      add_spring_damping(system_.springs, system_.spring_damping, x_, v, f);
    for (size_t i = 0; i < f.size(); ++i) {
      if (with_drag) f[i] -= system_.drag * v[i];
      f[i] = pinned_[i] ? Vec{} : (1 / system_.masses[i]) * f[i] + system_.gravity;
    }
    return f;
  }

  std::vector<Vec> following() const {
    std::vector<Vec> lagged(x_.size());
    for (size_t i = 0; i < x_.size(); ++i) lagged[i] = (1 / dt_) * (x_[i] - previous_[i]);
    const std::vector<Vec> a = accelerations(lagged, !system_.central_drag);
    std::vector<Vec> next(x_.size());
    for (size_t i = 0; i < x_.size(); ++i) {
      if (pinned_[i]) {
        next[i] = pin(uint32_t(i), (n_ + 1) * dt_);
        continue;
      }
      const double g = system_.central_drag ? system_.drag * dt_ / system_.masses[i] : 0;
      next[i] = (1 / (1 + g / 2)) * (2 * x_[i] - (1 - g / 2) * previous_[i] + (dt_ * dt_) * a[i]);
    }
    return next;
  }

  System system_;
  double dt_;
  int n_ = 0;
  std::vector<Vec> x_, previous_;
  std::vector<bool> pinned_;
};

}  // namespace reference
