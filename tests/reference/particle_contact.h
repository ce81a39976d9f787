// Particles that push each other apart, in double precision and by brute force: what weft's
// self-collision is compared with. Nothing here comes from weft.
#pragma once

#include "reference/vec.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace reference {

/// A particle after it went `d` in a substep. `distance` m is its cloth's; two of different cloths
/// take the mean.
struct ContactParticle {
  Vec x, d;
  double inverse_mass = 1;  ///< 1/kg; 0: pinned
  double distance = 0.1;
  Vec rest = {};
  uint32_t cloth = 0;
};

inline double contact_distance(const ContactParticle& a, const ContactParticle& b) {
  return 0.5 * (a.distance + b.distance);
}
/// Whether two particles touch: nearer than their distance now, and not at rest.
inline bool touch(const ContactParticle& a, const ContactParticle& b) {
  const double r = contact_distance(a, b);
  if (a.cloth == b.cloth && length(a.rest - b.rest) < r) return false;
  return length(a.x - b.x) < r;
}

/// One pass over all pairs, each from the positions before it. A pair parts by its overlap and its
/// relative displacement loses its approach, and what friction takes of the rest, by inverse
/// masses and divided by the larger of the numbers of partners.
/// Only pairs count that touched at the `first` positions too.
inline void push_apart(std::vector<ContactParticle>& all, double friction,
                       const std::vector<ContactParticle>& first) {
  const size_t n = all.size();
  std::vector<int> partners(n, 0);
  const auto meet = [&](size_t i, size_t j) {
    return touch(all[i], all[j]) && touch(first[i], first[j]);
  };
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < n; ++j) partners[i] += i != j && meet(i, j);
  std::vector<Vec> moved(n), braked(n);
  for (size_t i = 0; i < n; ++i)
    for (size_t j = i + 1; j < n; ++j) {
      const ContactParticle &a = all[i], &b = all[j];
      const double w = a.inverse_mass + b.inverse_mass;
      if (w == 0 || !meet(i, j)) continue;
      const Vec line = b.x - a.x, closing = b.d - a.d;
      const double gap = length(line);
      const Vec along = (1 / gap) * line;
      const double approach = std::max(0.0, -dot(closing, along));
      const Vec slide = closing - dot(closing, along) * along;
      const double speed = length(slide), held = std::min(speed, friction * approach);
      const Vec drag = speed > 0 ? (held / speed) * slide : Vec{};
      const double scale = 1 / (w * std::max(partners[i], partners[j]));
      const Vec part = (contact_distance(a, b) - gap) * along - drag;
      const Vec brake = approach * along - drag;
      moved[i] -= scale * a.inverse_mass * part;
      moved[j] += scale * b.inverse_mass * part;
      braked[i] -= scale * a.inverse_mass * brake;
      braked[j] += scale * b.inverse_mass * brake;
    }
  for (size_t i = 0; i < n; ++i) {
    all[i].x += moved[i];
    all[i].d += braked[i];
  }
}

/// A substep of particles that no force moves.
inline void contact_step(std::vector<ContactParticle>& all, double friction) {
  for (ContactParticle& p : all)
    if (p.inverse_mass > 0) p.x += p.d;
  const std::vector<ContactParticle> first = all;
  for (int pass = 0; pass < 4; ++pass) push_apart(all, friction, first);
}

}  // namespace reference
