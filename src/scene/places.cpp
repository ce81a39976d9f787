#include "scene/places.h"

#include <cmath>

#include "base/message_host.h"

namespace weft::scene {

size_t Places::CellHash::operator()(const Cell& c) const {
  auto h = static_cast<uint64_t>(c.x) * 0x9e3779b97f4a7c15ull;
  h = (h ^ static_cast<uint64_t>(c.y)) * 0xc2b2ae3d27d4eb4full;
  return static_cast<size_t>((h ^ static_cast<uint64_t>(c.z)) * 0x165667b19e3779f9ull);
}

Places::Cell Places::cell_of(double x, double y, double z) const {
  const auto part = [&](double c) {
    const double cell = std::floor(c / cell_);
    if (std::fabs(cell) < 9e15) return static_cast<int64_t>(cell);
    throw InvalidInput(
        text("weld_distance is %g m (too small for a mesh that reaches to %g m) give a larger one",
             distance_, c));
  };
  return {part(x), part(y), part(z)};
}

uint32_t Places::of(const double3& x) {
  const double d = distance_;
  const Cell low = cell_of(x.x - d, x.y - d, x.z - d), high = cell_of(x.x + d, x.y + d, x.z + d);
  uint32_t first = none;
  Cell at;
  for (at.x = low.x; at.x <= high.x; ++at.x) {
    for (at.y = low.y; at.y <= high.y; ++at.y) {
      for (at.z = low.z; at.z <= high.z; ++at.z) {
        const auto found = last_.find(at);
        if (found == last_.end()) continue;
        for (uint32_t p = found->second; p != none; p = next_[p]) {
          const double3& y = places_[p];
          const double a = x.x - y.x, b = x.y - y.y, c = x.z - y.z;
          if (p < first && a * a + b * b + c * c < d * d) first = p;
        }
      }
    }
  }
  if (first != none) return first;
  uint32_t& last = last_.emplace(cell_of(x.x, x.y, x.z), none).first->second;
  next_.push_back(last);
  last = count();
  places_.push_back(x);
  return last;
}

}  // namespace weft::scene
