#include "scene/nearest_pins.h"

#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "scene/each_spring.h"

namespace weft::scene {

namespace {

double length(const CookedFabric& fabric, uint32_t i, uint32_t j, double rest) {
  if (rest >= 0) return rest;
  const double3 a = fabric.position_of(i), b = fabric.position_of(j);
  const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return std::sqrt(x * x + y * y + z * z);
}

/// Calls use(i, j, rest length) for every edge of a mesh or network; a mesh's inner edges come
/// twice.
template <class Use>
void each_edge(const CookedFabric& fabric, Use use) {
  if (fabric.triangles.empty()) {
    each_spring(fabric, [&](uint32_t i, uint32_t j, double, double rest) {
      use(i, j, length(fabric, i, j, rest));
    });
    return;
  }
  for (size_t t = 0; t < fabric.triangles.size(); t += 3) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t i = fabric.triangles[t + k], j = fabric.triangles[t + (k + 1) % 3];
      use(i, j, length(fabric, i, j, fabric.rest_length));
    }
  }
}

/// The edges of each vertex: of grids by their stencil, of others in compressed rows.
class Neighbours {
 public:
  Neighbours(const CookedFabric& fabric, std::pmr::memory_resource* memory)
      : fabric_(fabric), first_(memory), to_(memory) {
    if (fabric.is_grid) return;
    first_.assign(size_t(fabric.vertices) + 1, 0);
    each_edge(fabric, [&](uint32_t i, uint32_t j, double) {
      ++first_[size_t(i) + 1];
      ++first_[size_t(j) + 1];
    });
    for (size_t v = 0; v < fabric.vertices; ++v) first_[v + 1] += first_[v];
    to_.resize(first_.back());
    Array<size_t> next(first_.begin(), first_.end() - 1, first_.get_allocator());
    each_edge(fabric, [&](uint32_t i, uint32_t j, double rest) {
      to_[next[i]++] = {j, rest};
      to_[next[j]++] = {i, rest};
    });
  }

  /// Calls use(neighbour, rest length).
  template <class Use>
  void each(uint32_t v, Use use) const {
    if (fabric_.is_grid) return each_of_grid(v, use);
    for (size_t e = first_[v]; e < first_[size_t(v) + 1]; ++e) use(to_[e].first, to_[e].second);
  }

 private:
  template <class Use>
  void each_of_grid(uint32_t v, Use use) const {
    const CookedGrid& g = fabric_.grid;
    const StencilTable& table = stencil_table(g.stencil);
    const int64_t row = v / g.columns, column = v % g.columns;
    for (int k = 0; k < table.count; ++k) {
      const StencilOffset o = table.offset[k];
      if (!has_neighbour(g, row, column, o)) continue;
      const auto j = static_cast<uint32_t>((row + o.row) * g.columns + column + o.column);
      if (!are_two_apart(g, v, j)) use(j, length(fabric_, v, j, fabric_.rest_length));
    }
  }

  const CookedFabric& fabric_;
  Array<size_t> first_;
  Array<std::pair<uint32_t, double>> to_;
};

}  // namespace

/// Dijkstra from all pins at once.
NearestPins nearest_pins(const CookedFabric& fabric, const Array<uint32_t>& pins,
                         std::pmr::memory_resource* memory) {
  const Neighbours neighbours(fabric, memory);
  NearestPins nearest(memory);
  nearest.pin.assign(fabric.vertices, no_pin);
  nearest.distance.assign(fabric.vertices, std::numeric_limits<double>::infinity());
  using Way = std::tuple<double, uint32_t, uint32_t>;  // length, pin, vertex
  std::priority_queue<Way, Array<Way>, std::greater<>> ways{std::greater<>(), Array<Way>(memory)};
  const auto relax = [&](double distance, uint32_t pin, uint32_t v) {
    if (std::tie(distance, pin) >= std::tie(nearest.distance[v], nearest.pin[v])) return;
    nearest.distance[v] = distance;
    nearest.pin[v] = pin;
    ways.push({distance, pin, v});
  };
  for (const uint32_t pin : pins) relax(0, pin, pin);
  while (!ways.empty()) {
    const auto [distance, pin, v] = ways.top();
    ways.pop();
    if (distance > nearest.distance[v] || pin != nearest.pin[v]) continue;
    neighbours.each(v, [&, way = distance, from = pin](uint32_t to, double rest) {
      relax(way + rest, from, to);
    });
  }
  return nearest;
}

}  // namespace weft::scene
