#include "bench/irregular.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <unordered_map>

#include "bench/random.h"

namespace weft::bench {

namespace {

uint64_t key(uint32_t a, uint32_t b) { return uint64_t(std::min(a, b)) << 32 | std::max(a, b); }

/// Triangles that change places across their edges.
class Flipper {
 public:
  explicit Flipper(TriangleSheet& sheet)
      : t_(sheet.triangles), valence_(sheet.positions.size(), 0) {
    for (uint32_t i = 0; i < t_.size() / 3; ++i) {
      for (uint32_t c = 0; c < 3; ++c) join(i, corner(i, c), corner(i, c + 1));
    }
    for (const auto& [edge, sides] : sides_) {
      ++valence_[edge >> 32];
      ++valence_[edge & 0xffffffffu];
    }
  }

  /// Gives the corners of the sheet that have two neighbours a third.
  void lift_corners() {
    for (uint32_t t = 0; t < t_.size() / 3; ++t) {
      for (uint32_t side = 0; side < 3; ++side) {
        if (valence_[corner(t, side + 2)] == 2) flip(t, side);
      }
    }
  }

  /// Flips an edge of a triangle, if valences stay in 3 to 12 and the new edge is not there yet.
  void flip(uint32_t triangle, uint32_t side) {
    const uint32_t a = corner(triangle, side), b = corner(triangle, side + 1),
                   c = corner(triangle, side + 2);
    const auto edge = sides_.find(key(a, b));
    const Sides sides = edge->second;
    if (sides.second == none) return;
    const uint32_t other = sides.first == triangle ? sides.second : sides.first;
    uint32_t d = 0;
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t v = corner(other, k);
      if (v != a && v != b) d = v;
    }
    if (valence_[a] <= 3 || valence_[b] <= 3 || valence_[c] >= 12 || valence_[d] >= 12) return;
    if (sides_.count(key(c, d)) > 0) return;
    sides_.erase(edge);
    replace(key(b, c), triangle, other);
    replace(key(a, d), other, triangle);
    sides_[key(c, d)] = {triangle, other};
    set(triangle, c, a, d);
    set(other, d, b, c);
    --valence_[a];
    --valence_[b];
    ++valence_[c];
    ++valence_[d];
  }

 private:
  static constexpr uint32_t none = ~0u;
  struct Sides {
    uint32_t first = none, second = none;
  };

  uint32_t corner(uint32_t t, uint32_t c) const { return t_[size_t(3) * t + c % 3]; }
  void set(uint32_t t, uint32_t a, uint32_t b, uint32_t c) {
    t_[size_t(3) * t] = a;
    t_[size_t(3) * t + 1] = b;
    t_[size_t(3) * t + 2] = c;
  }
  void join(uint32_t t, uint32_t a, uint32_t b) {
    Sides& sides = sides_[key(a, b)];
    (sides.first == none ? sides.first : sides.second) = t;
  }
  void replace(uint64_t edge, uint32_t from, uint32_t to) {
    Sides& sides = sides_[edge];
    (sides.first == from ? sides.first : sides.second) = to;
  }

  std::vector<uint32_t>& t_;
  std::vector<uint32_t> valence_;
  std::unordered_map<uint64_t, Sides> sides_;
};

}  // namespace

TriangleSheet irregular_sheet(uint32_t n, bool shuffled) {
  TriangleSheet sheet = triangle_sheet(n);
  Random random(7);
  Flipper flipper(sheet);
  flipper.lift_corners();
  const auto triangles = static_cast<uint32_t>(sheet.triangles.size() / 3);
  for (uint32_t i = 0; i < 4 * triangles; ++i) {
    const uint32_t t = random.below(triangles);
    flipper.flip(t, random.below(3));
  }
  if (!shuffled) return sheet;
  std::vector<uint32_t> name(sheet.positions.size());
  std::iota(name.begin(), name.end(), 0u);
  for (uint32_t i = n * n - 1; i > 0; --i) std::swap(name[i], name[random.below(i + 1)]);
  std::vector<double3> positions(sheet.positions.size());
  for (size_t i = 0; i < positions.size(); ++i) positions[name[i]] = sheet.positions[i];
  sheet.positions = positions;
  for (uint32_t& v : sheet.triangles) v = name[v];
  return sheet;
}

Valences valences_of(const TriangleSheet& sheet) {
  std::vector<std::set<uint32_t>> neighbours(sheet.positions.size());
  for (size_t t = 0; t < sheet.triangles.size(); ++t) {
    const uint32_t a = sheet.triangles[t], b = sheet.triangles[t % 3 == 2 ? t - 2 : t + 1];
    neighbours[a].insert(b);
    neighbours[b].insert(a);
  }
  Valences found{~0u, 0};
  for (const std::set<uint32_t>& of : neighbours) {
    found.least = std::min(found.least, static_cast<uint32_t>(of.size()));
    found.most = std::max(found.most, static_cast<uint32_t>(of.size()));
  }
  return found;
}

}  // namespace weft::bench
