#include "scene/weld.h"

#include <cmath>
#include <unordered_map>

#include "base/message_host.h"

namespace weft::scene {

namespace {

struct Cell {
  int64_t x, y, z;
  friend bool operator==(const Cell& a, const Cell& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }
};
struct CellHash {
  size_t operator()(const Cell& c) const {
    auto h = static_cast<uint64_t>(c.x) * 0x9e3779b97f4a7c15ull;
    h = (h ^ static_cast<uint64_t>(c.y)) * 0xc2b2ae3d27d4eb4full;
    return static_cast<size_t>((h ^ static_cast<uint64_t>(c.z)) * 0x165667b19e3779f9ull);
  }
};

/// Particles by cells as wide as the distance: who is near lies in one of 27.
class Particles {
 public:
  explicit Particles(double distance) : distance_(distance) {}

  /// The first particle within the distance, which may be the point itself as a new one.
  uint32_t of(const double3& x, Vector<double3>& positions) {
    const Cell cell = cell_of(x);
    uint32_t first = none;
    for (int k = 0; k < 27; ++k) {
      const auto found =
          cells_.find({cell.x + k % 3 - 1, cell.y + k / 3 % 3 - 1, cell.z + k / 9 - 1});
      if (found == cells_.end()) continue;
      for (const uint32_t p : found->second) {
        const double3& y = positions[p];
        const double a = x.x - y.x, b = x.y - y.y, c = x.z - y.z;
        if (p < first && a * a + b * b + c * c <= distance_ * distance_) first = p;
      }
    }
    if (first != none) return first;
    cells_[cell].push_back(static_cast<uint32_t>(positions.size()));
    positions.push_back(x);
    return static_cast<uint32_t>(positions.size() - 1);
  }

 private:
  static constexpr uint32_t none = ~0u;
  Cell cell_of(const double3& x) const {
    const auto part = [&](double c) {
      const double cell = std::floor(c / distance_);
      if (std::fabs(cell) < 9e15) return static_cast<int64_t>(cell);
      throw InvalidInput(text(
          "weld_distance is %g m (too small for a mesh that reaches to %g m) give a larger one",
          distance_, c));
    };
    return {part(x.x), part(x.y), part(x.z)};
  }

  double distance_;
  std::unordered_map<Cell, Vector<uint32_t>, CellHash, std::equal_to<Cell>,
                     HostAllocator<std::pair<const Cell, Vector<uint32_t>>>>
      cells_;
};

}  // namespace

Welded weld(const MeshDesc& desc) {
  Welded out;
  const double scale = desc.material.scale;
  Particles particles(desc.weld_distance / scale);
  const View<double>& masses = desc.material.mass.values;
  for (uint32_t v = 0; v < desc.positions.count; ++v) {
    const size_t before = out.positions.size();
    out.particle_of.push_back(particles.of(desc.positions[v], out.positions));
    if (out.positions.size() > before && !masses.empty()) out.masses.push_back(masses[v]);
  }
  for (uint32_t t = 0; t + 2 < desc.indices.count; t += 3) {
    const uint32_t a = out.particle_of[desc.indices[t]], b = out.particle_of[desc.indices[t + 1]],
                   c = out.particle_of[desc.indices[t + 2]];
    if (a == b || b == c || a == c) {
      ++out.dropped;
    } else {
      out.indices.insert(out.indices.end(), {a, b, c});
    }
  }
  out.mesh = desc;
  out.mesh.positions = View<double3>(out.positions);
  out.mesh.indices = out.indices;
  out.mesh.weld_distance = 0;
  if (!out.masses.empty()) out.mesh.material.mass.values = out.masses;
  return out;
}

}  // namespace weft::scene
