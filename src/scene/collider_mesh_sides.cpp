#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/message_host.h"
#include "scene/collider_mesh_parts.h"
#include "scene/trigonometry.h"

namespace weft::scene {

using namespace WEFT_BACKEND_NS;

namespace {

/// An edge of a triangle, along its direction or against it.
struct Side {
  uint32_t low, high;  ///< welded vertices
  uint32_t corner;     ///< 3 * triangle + number of the corner where the edge starts
  bool ascending;      ///< runs from low to high
  friend bool operator<(const Side& x, const Side& y) {
    return x.low != y.low     ? x.low < y.low
           : x.high != y.high ? x.high < y.high
                              : x.corner < y.corner;
  }
};

uint32_t next_corner(uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

/// Sorted by edge, without those of triangles that are in one place twice: they close nothing.
Vector<Side> sorted_sides(const Vector<uint32_t>& welded,
                               const Vector<uint32_t>& vertex) {
  Vector<Side> sides;
  sides.reserve(vertex.size());
  for (uint32_t c = 0; c < vertex.size(); ++c) {
    const uint32_t next = next_corner(c);
    const uint32_t a = welded[vertex[c]], b = welded[vertex[next]];
    const uint32_t opposite = welded[vertex[next_corner(next)]];
    if (a == b || a == opposite || b == opposite) continue;
    sides.push_back({std::min(a, b), std::max(a, b), c, a < b});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

size_t end_of_edge(const Vector<Side>& sides, size_t first) {
  size_t end = first + 1;
  while (end < sides.size() && sides[end].low == sides[first].low &&
         sides[end].high == sides[first].high) {
    ++end;
  }
  return end;
}

/// The sides of one edge.
void check_edge(const Side* side, size_t count, const Vector<uint32_t>& vertex) {
  const uint32_t a = vertex[side[0].corner], b = vertex[next_corner(side[0].corner)];
  if (count == 1) {
    throw InvalidInput(
        text("edge %u-%u has triangle %u only (a closed mesh has two at every edge) fill the hole "
             "or set closed to false",
             a, b, side[0].corner / 3));
  }
  const auto ascending = std::count_if(side, side + count, [](Side s) { return s.ascending; });
  if (count == 2 && ascending != 1) {
    throw InvalidInput(
        text("triangles %u and %u both run from vertex %u to vertex %u (in a closed mesh one runs "
             "each way, so that it has an inside) turn one of them round",
             side[0].corner / 3, side[1].corner / 3, a, b));
  }
  if (count > 2) {
    throw InvalidInput(
        text("edge %u-%u has %zu triangles, the first are %u, %u and %u (a closed mesh has two at "
             "every edge) take the others away or set closed to false",
             a, b, count, side[0].corner / 3, side[1].corner / 3, side[2].corner / 3));
  }
}

/// Without the C library, whose bits depend on the processor.
double angle_at(const CookedColliderMesh& mesh, uint32_t corner) {
  const int c = int(corner % 3);
  const Point at = corner_of(mesh, corner / 3, c);
  const Point a = corner_of(mesh, corner / 3, (c + 1) % 3) - at;
  const Point b = corner_of(mesh, corner / 3, (c + 2) % 3) - at;
  const double scale = length(a) * length(b);
  const double sine = length(cross(a, b)) / scale, cosine = dot(a, b) / scale;
  double angle = (1 - cosine) * 1.57;  // within 0.34; the error is cubed in every round
  for (int round = 0; round < 3; ++round) {
    const SineCosine guess = sine_cosine(angle);
    angle += sine * guess.cosine - cosine * guess.sine;
  }
  return angle;
}

/// Of unit length; the face's own normal where the sum has none.
void store_side(Point sum, uint32_t triangle, uint32_t feature, CookedColliderMesh& mesh) {
  const double size = length(sum);
  const Point n = size > 1e-12 ? (1 / size) * sum : normal_of(mesh, triangle);
  double* out = &mesh.sides[size_t(triangle) * 18 + feature * 3];
  out[0] = n.x;
  out[1] = n.y;
  out[2] = n.z;
}

}  // namespace

Vector<uint32_t> weld(const Vector<double3>& positions) {
  Vector<uint32_t> order(positions.size()), welded(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto before = [&](uint32_t v, uint32_t w) {
    const double3 a = positions[v], b = positions[w];
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z != b.z ? a.z < b.z : v < w;
  };
  std::sort(order.begin(), order.end(), before);
  uint32_t first = 0;
  for (size_t i = 0; i < order.size(); ++i) {
    const double3 a = positions[order[i]], b = positions[order[first]];
    if (a.x != b.x || a.y != b.y || a.z != b.z) first = static_cast<uint32_t>(i);
    welded[order[i]] = order[first];
  }
  return welded;
}

void check_closed(const Vector<double3>& positions, const Vector<uint32_t>& welded,
                  const Vector<uint32_t>& vertex) {
  const Vector<Side> sides = sorted_sides(welded, vertex);
  for (size_t first = 0; first < sides.size();) {
    const size_t end = end_of_edge(sides, first);
    check_edge(&sides[first], end - first, vertex);
    first = end;
  }
  double volume = 0, size = 0;
  const double3 origin = positions[vertex[0]];
  for (size_t c = 0; c + 2 < vertex.size(); c += 3) {
    Point corner[3];
    for (size_t i = 0; i < 3; ++i) {
      const double3 p = positions[vertex[c + i]];
      corner[i] = {p.x - origin.x, p.y - origin.y, p.z - origin.z};
    }
    const double part = dot(corner[0], cross(corner[1], corner[2])) / 6;
    volume += part;
    size += std::fabs(part);
  }
  if (volume < -1e-9 * size) {
    throw InvalidInput(
        text("the closed mesh has a volume of %g m3 (its triangles run clockwise seen from "
             "outside, so that its inside is out) reverse the triangles",
             volume));
  }
}

void set_sides(const Vector<uint32_t>& welded, const Vector<uint32_t>& vertex,
               CookedColliderMesh& mesh) {
  mesh.sides.resize(vertex.size() * 6);
  const Vector<Side> sides = sorted_sides(welded, vertex);
  for (size_t first = 0; first < sides.size();) {
    const size_t end = end_of_edge(sides, first);
    Point sum{0, 0, 0};
    for (size_t s = first; s < end; ++s) sum = sum + normal_of(mesh, sides[s].corner / 3);
    for (size_t s = first; s < end; ++s) {
      store_side(sum, sides[s].corner / 3, sides[s].corner % 3, mesh);
    }
    first = end;
  }
  Vector<Point> of_vertex(welded.size(), Point{0, 0, 0});
  for (uint32_t c = 0; c < vertex.size(); ++c) {
    Point& sum = of_vertex[welded[vertex[c]]];
    sum = sum + angle_at(mesh, c) * normal_of(mesh, c / 3);
  }
  for (uint32_t c = 0; c < vertex.size(); ++c) {
    store_side(of_vertex[welded[vertex[c]]], c / 3, 3 + c % 3, mesh);
  }
}

}  // namespace weft::scene
