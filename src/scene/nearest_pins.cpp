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

/// Calls use(i, j, rest length) for every edge of the surface; those of two triangles come twice.
template <class Use>
void each_edge(const CookedFabric& fabric, Use use) {
  if (fabric.triangles.empty()) {
    each_spring(fabric, [&](uint32_t i, uint32_t j, double, double rest) {
      if (fabric.is_grid && are_two_apart(fabric.grid, i, j)) return;
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

/// The edges of each vertex, in compressed rows.
struct Neighbours {
  explicit Neighbours(const CookedFabric& fabric) : first(size_t(fabric.vertices) + 1, 0) {
    each_edge(fabric, [&](uint32_t i, uint32_t j, double) {
      ++first[size_t(i) + 1];
      ++first[size_t(j) + 1];
    });
    for (size_t v = 0; v < fabric.vertices; ++v) first[v + 1] += first[v];
    to.resize(first.back());
    std::vector<size_t> next(first.begin(), first.end() - 1);
    each_edge(fabric, [&](uint32_t i, uint32_t j, double rest) {
      to[next[i]++] = {j, rest};
      to[next[j]++] = {i, rest};
    });
  }
  std::vector<size_t> first;
  std::vector<std::pair<uint32_t, double>> to;
};

}  // namespace

/// Dijkstra from all pins at once.
NearestPins nearest_pins(const CookedFabric& fabric, const std::vector<uint32_t>& pins) {
  const Neighbours neighbours(fabric);
  NearestPins nearest;
  nearest.pin.assign(fabric.vertices, no_pin);
  nearest.distance.assign(fabric.vertices, std::numeric_limits<double>::infinity());
  using Way = std::tuple<double, uint32_t, uint32_t>;  // length, pin, vertex
  std::priority_queue<Way, std::vector<Way>, std::greater<>> ways;
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
    for (size_t e = neighbours.first[v]; e < neighbours.first[size_t(v) + 1]; ++e) {
      relax(distance + neighbours.to[e].second, pin, neighbours.to[e].first);
    }
  }
  return nearest;
}

}  // namespace weft::scene
