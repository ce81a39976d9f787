#include "render/ridges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace weft::render {
namespace {

/// Vertices in one place have one number.
std::vector<uint32_t> welded(const std::vector<Vector3d>& points) {
  std::vector<uint32_t> order(points.size()), number(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto before = [&](uint32_t i, uint32_t j) {
    return std::lexicographical_compare(points[i].begin(), points[i].end(), points[j].begin(),
                                        points[j].end());
  };
  std::sort(order.begin(), order.end(), before);
  for (size_t k = 0; k < order.size(); ++k) {
    const bool same = k > 0 && points[order[k]] == points[order[k - 1]];
    number[order[k]] = same ? number[order[k - 1]] : order[k];
  }
  return number;
}

/// A side of a triangle.
struct Side {
  uint32_t low, high;  ///< welded
  uint32_t corner;     ///< where it starts, three per triangle
};

uint32_t next_corner(uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

constexpr double never = 1e300;

/// Where a ray goes through a triangle, in lengths of `way` (Moeller & Trumbore 1997).
double crossing(const Vector3d* corners, const Vector3d& from, const Vector3d& way) {
  const Vector3d ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  const Vector3d start = from - corners[0], across = way.cross(ac), back = start.cross(ab);
  const double scale = ab.dot(across);
  if (scale == 0) return never;
  const double u = start.dot(across) / scale, v = way.dot(back) / scale;
  const double at = ac.dot(back) / scale;
  return u >= 0 && v >= 0 && u + v <= 1 && at > 0 ? at : never;
}

}  // namespace

Ridges::Ridges(const io::Mesh& mesh, double scale, bool closed) {
  for (const double3& p : mesh.positions) points_.push_back(scale * vector(p));
  welded_ = welded(points_);
  std::vector<Box> boxes;
  for (const uint32_t v : mesh.triangles) {
    if (corners_.size() % 3 == 0) boxes.emplace_back();
    corner_.push_back(welded_[v]);
    corners_.push_back(points_[v]);
    boxes.back().add(points_[v]);
    box_.add(points_[v]);
  }
  find_outside(closed);
  find_edges();
  find_outward();
  near_triangles_ = BoxTree(boxes);
  boxes.clear();
  for (const Edge& edge : edges_) {
    boxes.emplace_back().add(edge.a);
    boxes.back().add(edge.b);
  }
  near_edges_ = BoxTree(boxes);
  boxes.clear();
  for (const Vector3d& p : points_) boxes.push_back({p, p});
  near_points_ = BoxTree(boxes);
}

// By the volume in it, of which a sphere has the most for its area: 0.094 area^1.5.
void Ridges::find_outside(bool closed) {
  double area = 0, volume = 0;
  for (size_t c = 0; c + 2 < corners_.size(); c += 3) {
    const Vector3d across = (corners_[c + 1] - corners_[c]).cross(corners_[c + 2] - corners_[c]);
    area += across.norm() / 2;
    volume += (corners_[c] - box_.center()).dot(across) / 6;
  }
  const double share = volume / std::pow(area, 1.5);
  outside_ = closed || share > 0.015 ? 1 : share < -0.015 ? -1 : 0;
}

void Ridges::find_edges() {
  std::vector<Side> sides;
  for (uint32_t c = 0; c < corners_.size(); ++c) {
    const uint32_t i = corner_[c], j = corner_[next_corner(c)];
    if (i != j) sides.push_back({std::min(i, j), std::max(i, j), c});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::array{x.low, x.high, x.corner} < std::array{y.low, y.high, y.corner};
  });
  const auto normal_of = [&](const Side& s) -> Vector3d {
    const size_t first = s.corner - s.corner % 3;
    return (corners_[first + 1] - corners_[first])
        .cross(corners_[first + 2] - corners_[first])
        .normalized();
  };
  for (size_t i = 0, end = 0; i < sides.size(); i = end) {
    Vector3d sum(0, 0, 0);
    for (end = i;
         end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high;
         ++end) {
      sum += normal_of(sides[end]);
    }
    const uint32_t from = sides[i].corner, to = next_corner(from);
    const Vector3d a = corners_[from], b = corners_[to];
    if (end - i == 2) {
      const Vector3d other = corners_[next_corner(next_corner(sides[i + 1].corner))] - a;
      const double rise = normal_of(sides[i]).dot(other);
      if (!(outside_ * rise < -1e-9 * other.norm()) && outside_ != 0) continue;
    }
    const double flat = sum.norm() / double(end - i);
    const double sign = outside_ < 0 ? -1 : 1;
    const Vector3d out = flat > 1e-6 ? Vector3d(sign * sum.normalized()) : Vector3d(0, 0, 0);
    edges_.push_back({a, b, corner_[from], corner_[to], out, flat});
  }
}

double Ridges::first_crossing(const Vector3d& from, const Vector3d& to) const {
  const Vector3d way = to - from;
  const double length = way.norm(), hair = 1e-6 * box_.radius();
  Box around;
  around.add(from);
  around.add(to);
  double first = never;
  near_triangles_.each_near(around, [&](uint32_t triangle) {
    const double at = crossing(&corners_[3 * size_t(triangle)], from, way);
    if (at <= 1 && at * length > hair) first = std::min(first, at * length);
  });
  return first;
}

void Ridges::add(const std::array<Vector3d, 3>& t, Depths& depths) const {
  Box around;
  for (const Vector3d& corner : t) around.add(corner);
  if (!is_crossed(t, around)) return;
  const double longest =
      std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
  // No point of a triangle is farther from the nearest corner, which is outside.
  const double most = longest / std::sqrt(3.0);
  // Along a normal it may be somewhat farther: past the edge is another side.
  const double farthest = 1.5 * most;
  near_edges_.each_near(around.grown(farthest), [&](uint32_t number) {
    depths[number] = std::max(depths[number], depth_below(edges_[number], t, most));
  });
  near_points_.each_near(around.grown(farthest), [&](uint32_t v) {
    double& depth = depths[edges_.size() + v];
    depth = std::max(depth, depth_of(v, t, farthest));
  });
}

/// A vertex is above a triangle where the way inwards from it meets it, and no side of the mesh
/// before.
double Ridges::depth_of(uint32_t v, const std::array<Vector3d, 3>& t, double farthest) const {
  if (welded_[v] != v || outside_ == 0) return 0;
  const Outward& out = outward_[v];
  const Vector3d in = -farthest / out.least * out.normal;
  const double at = crossing(t.data(), points_[v], in);
  if (!(at <= 1) || first_crossing(points_[v], points_[v] + at * in) < never) return 0;
  return at * farthest;
}

/// By an edge, or by a triangle at one of its sides.
bool Ridges::is_crossed(const std::array<Vector3d, 3>& t, const Box& around) const {
  bool crossed = false;
  near_edges_.each_near(around, [&](uint32_t number) {
    const Edge& edge = edges_[number];
    crossed = crossed || crossing(t.data(), edge.a, edge.b - edge.a) <= 1;
  });
  return crossed || first_crossing(t[0], t[1]) < never || first_crossing(t[1], t[2]) < never ||
         first_crossing(t[2], t[0]) < never;
}

/// Below an edge, depth is the distance to the nearer of its two faces. It is greatest halfway
/// between them: at an end of the line in which that plane cuts the triangle.
double Ridges::depth_below(const Edge& edge, const std::array<Vector3d, 3>& t, double most) const {
  const Vector3d along = edge.b - edge.a, across = along.cross(edge.out);
  std::array<Vector3d, 2> ends;
  size_t count = 0;
  std::array<double, 3> side;
  for (size_t i = 0; i < 3; ++i) side[i] = across.dot(t[i] - edge.a);
  for (size_t i = 0; i < 3 && count < 2; ++i) {
    const size_t j = (i + 1) % 3;
    if ((side[i] < 0) != (side[j] < 0)) {
      ends[count++] = t[i] + side[i] / (side[i] - side[j]) * (t[j] - t[i]);
    }
  }
  if (count < 2) return 0;
  // From 0 to 1 along the edge, and how far below it.
  std::array<double, 2> at, below;
  for (size_t k = 0; k < 2; ++k) {
    at[k] = along.dot(ends[k] - edge.a) / along.squaredNorm();
    below[k] = -edge.out.dot(ends[k] - edge.a);
  }
  double found = 0;
  for (size_t k = 0; k < 2; ++k) {
    const double end = std::clamp(at[k], 0.0, 1.0), other = at[1 - k];
    if (end != at[k] && (other - end) * (end - at[k]) < 0) continue;  // all beyond the edge's end
    const double part = end == at[k] ? 0 : (end - at[k]) / (other - at[k]);
    const double deep = below[k] + part * (below[1 - k] - below[k]), depth = deep * edge.flat;
    if (!(depth > found) || depth > 1.01 * most) continue;
    const Vector3d top = edge.a + end * along;
    // A crossing in between: the triangle is beyond what is below the edge.
    if (first_crossing(top, top - deep * edge.out) == never) found = std::min(depth, most);
  }
  return found;
}

/// Weighted by angle.
void Ridges::find_outward() {
  outward_.resize(points_.size());
  const auto each_corner = [&](auto use) {
    for (uint32_t c = 0; c < corners_.size(); ++c) {
      const uint32_t next = next_corner(c);
      const Vector3d a = corners_[next] - corners_[c],
                     b = corners_[next_corner(next)] - corners_[c], area = a.cross(b);
      if (!(area.norm() > 0)) continue;
      const Vector3d normal = (outside_ < 0 ? -1 : 1) * area.normalized();
      use(outward_[corner_[c]], normal, std::atan2(area.norm(), a.dot(b)));
    }
  };
  each_corner([](Outward& v, const Vector3d& n, double angle) { v.normal += angle * n; });
  for (Outward& v : outward_) v.normal.normalize();
  each_corner(
      [](Outward& v, const Vector3d& n, double) { v.least = std::min(v.least, n.dot(v.normal)); });
  constexpr double sharpest = 0.4;
  for (Outward& v : outward_) v.least = std::max(v.least, sharpest);
}

Ridges::Inset Ridges::inset(const Depths& depths) const {
  Inset inset;
  std::vector<double> depth(depths.begin() + std::ptrdiff_t(edges_.size()), depths.end());
  for (size_t e = 0; e < edges_.size(); ++e) {
    for (const uint32_t v : {edges_[e].from, edges_[e].to})
      depth[v] = std::max(depth[v], depths[e]);
  }
  // Faces move in as a whole.
  std::vector<double> wanted(points_.size(), 0);
  for (size_t c = 0; c < corner_.size(); ++c) {
    for (size_t k = c - c % 3; k < c - c % 3 + 3; ++k) {
      wanted[corner_[c]] = std::max(wanted[corner_[c]], depth[corner_[k]]);
    }
  }
  if (std::none_of(wanted.begin(), wanted.end(), [](double d) { return d > 0; })) return inset;
  if (outside_ == 0) {
    inset.enough = false;
    return inset;
  }
  constexpr double most_of_the_way = 0.4;
  std::vector<Vector3d> by(points_.size(), Vector3d::Zero());
  for (size_t v = 0; v < points_.size(); ++v) {
    if (wanted[v] == 0) continue;
    const Vector3d out = wanted[v] / outward_[v].least * outward_[v].normal;
    const bool thick = first_crossing(points_[v], points_[v] - out / most_of_the_way) == never;
    if (thick) by[v] = out;
    inset.enough = inset.enough && (thick || depth[v] == 0);
  }
  for (const uint32_t v : welded_) inset.by.push_back(by[v]);
  return inset;
}

// By the triangles that a ray in an odd direction goes through.
bool Ridges::enclose(const Vector3d& from) const {
  const Vector3d way(0.3172, 0.5271, 0.7883);
  size_t crossed = 0;
  for (size_t c = 0; c + 2 < corners_.size(); c += 3) {
    crossed += crossing(&corners_[c], from, way) < never;
  }
  return crossed % 2 == 1;
}

}  // namespace weft::render
