// Exact solutions of the discrete equations: what Verlet must give but for rounding.
#pragma once

#include <cmath>
#include <numbers>

namespace reference {

/// Angle per step of u'' = -w^2 u: theta = 2 asin(w dt/2).
inline double verlet_angle(double w_dt) { return 2 * std::asin(w_dt / 2); }

/// u_n for x_(-1) = x0 - v0 dt + a0 dt^2/2.
inline double oscillator(double u0, double v0, double w, double dt, int n) {
  const double theta = verlet_angle(w * dt);
  return u0 * std::cos(n * theta) + v0 * dt / std::sin(theta) * std::sin(n * theta);
}

/// u_n for x_(-1) = x0, at rest.
inline double oscillator_lagged_start(double u0, double w, double dt, int n) {
  const double theta = verlet_angle(w * dt);
  return u0 * std::cos((n + 0.5) * theta) / std::cos(theta / 2);
}

/// u_(n+1) = p u_n - q u_(n-1) with complex roots, from u_0 and u_(-1).
inline double recurrence(double p, double q, double u0, double u_before, int n) {
  const double radius = std::sqrt(q);
  const double theta = std::acos(p / (2 * radius));
  // u_n = radius^n (u0 cos n theta + b sin n theta)
  const double b = (u0 * std::cos(theta) - radius * u_before) / std::sin(theta);
  return std::pow(radius, n) * (u0 * std::cos(n * theta) + b * std::sin(n * theta));
}

/// Georgii and Westermann's drag: z^2 - (2 - W - G) z + (1 - G) = 0; at rest, taylor start.
inline double lagged_drag_oscillator(double u0, double w, double g_factor, double dt, int n) {
  const double w2 = w * w * dt * dt;
  return recurrence(2 - w2 - g_factor, 1 - g_factor, u0, u0 * (1 - w2 / 2), n);
}

/// (1 + G/2) z^2 - (2 - W) z + (1 - G/2) = 0; at rest, taylor start.
inline double central_drag_oscillator(double u0, double w, double g_factor, double dt, int n) {
  const double w2 = w * w * dt * dt, denominator = 1 + g_factor / 2;
  return recurrence((2 - w2) / denominator, (1 - g_factor / 2) / denominator, u0, u0 * (1 - w2 / 2),
                    n);
}

/// Beyond the limit, W > 4: |z| = W/2 - 1 + sqrt(W^2/4 - W).
inline double growth(double w_dt) {
  const double w2 = w_dt * w_dt;
  return w2 / 2 - 1 + std::sqrt(w2 * w2 / 4 - w2);
}

/// x_n of a mass at rest at l0 whose anchor moves as speed * t.
inline double dragged_by_pin(double l0, double speed, double w, double dt, int n) {
  const double theta = verlet_angle(w * dt);
  return l0 + speed * n * dt - speed * dt / std::sin(theta) * std::sin(n * theta);
}

/// x_n of a mass at rest at l0 whose anchor moves as amplitude * sin(omega t).
inline double driven_by_pin(double l0, double amplitude, double omega, double w, double dt, int n) {
  const double theta = verlet_angle(w * dt), w2 = w * w * dt * dt;
  const double half = std::sin(omega * dt / 2);
  const double a = w2 * amplitude / (w2 - 4 * half * half);
  const double b = -a * std::sin(omega * dt) / std::sin(theta);
  return l0 + a * std::sin(n * omega * dt) + b * std::sin(n * theta);
}

enum class Ends { free_free, fixed_fixed, fixed_free };

/// Half of the phase of mode j: w_j = 2 sqrt(k/m) sin(phi). j from 0 (free) or 1.
inline double chain_phase(Ends ends, int masses, int j) {
  const double pi = std::numbers::pi;
  if (ends == Ends::free_free) return pi * j / (2 * masses);
  if (ends == Ends::fixed_fixed) return pi * j / (2 * (masses + 1));
  return pi * (2 * j - 1) / (2 * (2 * masses + 1));
}

/// Displacement of mass i (from 0) in mode j.
inline double chain_mode(Ends ends, int masses, int j, int i) {
  const double phase = 2 * chain_phase(ends, masses, j);
  return ends == Ends::free_free ? std::cos(phase * (i + 0.5)) : std::sin(phase * (i + 1));
}

/// The largest stable step for lagged damping: w dt = 2 (sqrt(1 + zeta^2) - zeta).
inline double lagged_damping_limit(double zeta) { return 2 * (std::sqrt(1 + zeta * zeta) - zeta); }

}  // namespace reference
