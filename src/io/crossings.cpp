#include "io/crossings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/orientation.h"

namespace weft::io {
namespace {

using Triangle = std::array<uint32_t, 3>;
using Corners = std::array<double3, 3>;

struct Box {
  std::array<double, 3> low, high;
  uint32_t triangle;
};

std::array<double, 3> array_of(const double3& v) { return {v.x, v.y, v.z}; }

std::vector<Box> boxes_of(const std::vector<double3>& positions,
                          const std::vector<Triangle>& triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (size_t t = 0; t < triangles.size(); ++t) {
    Box box{array_of(positions[triangles[t][0]]), array_of(positions[triangles[t][0]]),
            static_cast<uint32_t>(t)};
    bool finite = true;
    for (const uint32_t vertex : triangles[t]) {
      const auto v = array_of(positions[vertex]);
      for (size_t k = 0; k < 3; ++k) {
        finite = finite && std::isfinite(v[k]);
        box.low[k] = std::min(box.low[k], v[k]);
        box.high[k] = std::max(box.high[k], v[k]);
      }
    }
    if (finite) boxes.push_back(box);
  }
  return boxes;
}

/// The axis along which the boxes are short beside all of them together.
size_t best_axis(const std::vector<Box>& boxes) {
  std::array<double, 3> crowding{};
  for (size_t k = 0; k < 3; ++k) {
    double low = INFINITY, high = -INFINITY, lengths = 0;
    for (const Box& box : boxes) {
      low = std::min(low, box.low[k]);
      high = std::max(high, box.high[k]);
      lengths += box.high[k] - box.low[k];
    }
    crowding[k] = high > low ? lengths / (high - low) : INFINITY;
  }
  return static_cast<size_t>(std::min_element(crowding.begin(), crowding.end()) - crowding.begin());
}

bool share_a_vertex(const Triangle& s, const Triangle& t) {
  for (const uint32_t i : s) {
    if (i == t[0] || i == t[1] || i == t[2]) return true;
  }
  return false;
}

/// Turns the corners of `t` until the first is alone on its side of the plane of `other`, and turns
/// `other` over where that side is the negative one. False where `t` does not pass the plane.
bool put_lone_corner_first(Corners& t, Corners& other) {
  std::array<int, 3> side{};
  for (size_t k = 0; k < 3; ++k) side[k] = orientation(other[0], other[1], other[2], t[k]);
  if (*std::max_element(side.begin(), side.end()) <= 0) return false;
  if (*std::min_element(side.begin(), side.end()) >= 0) return false;
  const auto above = std::count(side.begin(), side.end(), 1);
  const int lone = above == 1 ? 1 : -1;
  while (side[0] != lone) {
    std::rotate(side.begin(), side.begin() + 1, side.end());
    std::rotate(t.begin(), t.begin() + 1, t.end());
  }
  if (lone < 0) std::swap(other[1], other[2]);
  return true;
}

// Each triangle cuts the line that both planes have in common in a segment whose ends lie on the
// edges of its lone corner. The segments overlap when each begins before the other ends (Guigue and
// Devillers, "Fast and robust triangle-triangle overlap test using orientation predicates", 2003).
bool cross(Corners s, Corners t) {
  if (!put_lone_corner_first(s, t) || !put_lone_corner_first(t, s)) return false;
  return orientation(s[0], s[1], t[0], t[1]) < 0 && orientation(s[0], s[2], t[2], t[0]) < 0;
}

}  // namespace

std::vector<std::array<uint32_t, 2>> crossings(const std::vector<double3>& positions,
                                               const std::vector<Triangle>& triangles) {
  std::vector<Box> boxes = boxes_of(positions, triangles);
  const size_t x = best_axis(boxes), y = (x + 1) % 3, z = (x + 2) % 3;
  std::sort(boxes.begin(), boxes.end(), [x](const Box& a, const Box& b) {
    return std::pair(a.low[x], a.triangle) < std::pair(b.low[x], b.triangle);
  });
  const auto corners_of = [&](uint32_t t) {
    return Corners{positions[triangles[t][0]], positions[triangles[t][1]],
                   positions[triangles[t][2]]};
  };
  std::vector<std::array<uint32_t, 2>> found;
  for (size_t i = 0; i < boxes.size(); ++i) {
    const Box& a = boxes[i];
    for (size_t j = i + 1; j < boxes.size() && boxes[j].low[x] <= a.high[x]; ++j) {
      const Box& b = boxes[j];
      if (a.high[y] < b.low[y] || b.high[y] < a.low[y]) continue;
      if (a.high[z] < b.low[z] || b.high[z] < a.low[z]) continue;
      if (share_a_vertex(triangles[a.triangle], triangles[b.triangle])) continue;
      if (!cross(corners_of(a.triangle), corners_of(b.triangle))) continue;
      found.push_back({std::min(a.triangle, b.triangle), std::max(a.triangle, b.triangle)});
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace weft::io
