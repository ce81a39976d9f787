#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/message_host.h"
#include "scene/collider_mesh_parts.h"
#include "scene/trigonometry.h"

namespace weft::scene {

using namespace WEFT_BACKEND_NS;

namespace {

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

Vector<Side> sorted_sides(const Surface& surface) {
  Vector<Side> sides;
  sides.reserve(surface.vertex.size());
  for (uint32_t c = 0; c < surface.vertex.size(); ++c) {
    const uint32_t next = next_corner(c);
    const uint32_t a = surface.place(c), b = surface.place(next);
    const uint32_t opposite = surface.place(next_corner(next));
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

namespace {

/// Corners of one vertex whose triangles hang together by edges: where pieces touch in a vertex,
/// each has a normal of its own there.
class CornerFans {
 public:
  explicit CornerFans(size_t corners) : parent_(corners) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  uint32_t of(uint32_t corner) {
    while (parent_[corner] != corner) {
      parent_[corner] = parent_[parent_[corner]];
      corner = parent_[corner];
    }
    return corner;
  }
  void join(uint32_t a, uint32_t b) {
    a = of(a);
    b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  /// Joins the triangles of two sides of one edge at both of its ends.
  void join(const Side& x, const Side& y) {
    const bool same = x.ascending == y.ascending;
    join(x.corner, same ? y.corner : next_corner(y.corner));
    join(next_corner(x.corner), same ? next_corner(y.corner) : y.corner);
  }

 private:
  Vector<uint32_t> parent_;
};

}  // namespace

void set_sides(const Surface& surface, CookedColliderMesh& mesh) {
  const size_t corners = surface.vertex.size();
  mesh.sides.resize(corners * 6);
  const Vector<Side> sides = sorted_sides(surface);
  CornerFans fans(corners);
  for (size_t first = 0; first < sides.size();) {
    const size_t end = end_of_edge(sides, first);
    Point sum{0, 0, 0};
    for (size_t s = first; s < end; ++s) sum = sum + normal_of(mesh, sides[s].corner / 3);
    for (size_t s = first; s < end; ++s) {
      store_side(sum, sides[s].corner / 3, sides[s].corner % 3, mesh);
      if (s > first) fans.join(sides[first], sides[s]);
    }
    first = end;
  }
  Vector<Point> of_fan(corners, Point{0, 0, 0});
  for (uint32_t c = 0; c < corners; ++c) {
    Point& sum = of_fan[fans.of(c)];
    sum = sum + angle_at(mesh, c) * normal_of(mesh, c / 3);
  }
  for (uint32_t c = 0; c < corners; ++c) store_side(of_fan[fans.of(c)], c / 3, 3 + c % 3, mesh);
}

}  // namespace weft::scene
