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

/// The pairs that touch after the particles went their way: how many partners the busier of the
/// two has, and what they have given each other's displacements, kg m.
struct ContactPair {
  size_t i, j;
  int partners;
  double impulse = 0;
};
inline std::vector<ContactPair> touching_pairs(const std::vector<ContactParticle>& all) {
  std::vector<ContactPair> pairs;
  std::vector<int> partners(all.size(), 0);
  for (size_t i = 0; i < all.size(); ++i)
    for (size_t j = i + 1; j < all.size(); ++j) {
      if (!touch(all[i], all[j])) continue;
      pairs.push_back({i, j, 0});
      ++partners[i];
      ++partners[j];
    }
  for (ContactPair& pair : pairs) pair.partners = std::max(partners[pair.i], partners[pair.j]);
  return pairs;
}

/// One pass over the pairs, each from the positions and displacements before it. A pair parts by
/// its overlap, of which four times up to `carried` m become displacement too; its impulse ends its
/// approach and never pulls; friction is limited by a quarter of it. All by inverse masses and
/// divided by the number of partners.
inline void push_apart(std::vector<ContactParticle>& all, std::vector<ContactPair>& pairs,
                       double friction, double carried) {
  std::vector<Vec> moved(all.size()), braked(all.size());
  for (ContactPair& pair : pairs) {
    const ContactParticle &a = all[pair.i], &b = all[pair.j];
    const double w = a.inverse_mass + b.inverse_mass;
    if (w == 0) continue;
    const Vec line = b.x - a.x, closing = b.d - a.d;
    const double gap = length(line);
    const Vec along = (1 / gap) * line;
    const double overlap = std::max(0.0, contact_distance(a, b) - gap);
    const double wanted = 4 * std::min(overlap, carried) - dot(closing, along);
    const double scale = 1 / (w * pair.partners);
    const double impulse = std::max(0.0, pair.impulse + scale * wanted);
    const double grown = impulse - pair.impulse;
    pair.impulse = impulse;
    const Vec slide = closing - dot(closing, along) * along;
    const double most = friction / 4 * impulse, speed = length(slide);
    const double held = std::min(scale * speed, most);
    const Vec drag = speed > 0 ? (held / speed) * slide : Vec{};
    const Vec part = scale * overlap * along - drag, brake = grown * along - drag;
    moved[pair.i] -= a.inverse_mass * part;
    moved[pair.j] += b.inverse_mass * part;
    braked[pair.i] -= a.inverse_mass * brake;
    braked[pair.j] += b.inverse_mass * brake;
  }
  for (size_t i = 0; i < all.size(); ++i) {
    all[i].x += moved[i];
    all[i].d += braked[i];
  }
}

/// A substep of particles that `fall` further in it than in the one before; overlaps of up to
/// `carried` m count as the weight of others.
inline void contact_step(std::vector<ContactParticle>& all, double friction, Vec fall = {},
                         double carried = 0) {
  for (ContactParticle& p : all) {
    if (p.inverse_mass == 0) continue;
    p.d += fall;
    p.x += p.d;
  }
  std::vector<ContactPair> pairs = touching_pairs(all);
  for (int pass = 0; pass < 4; ++pass) push_apart(all, pairs, friction, pass == 0 ? carried : 0.0);
}

}  // namespace reference
