#include "render/ridges.h"

#include "render/solids.h"

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
  uint32_t corner;     ///< where it starts
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

Ridges::Ridges(const io::MeshColliderScene& d)
    : closed_(d.closed),
      turn_(rotation(d.pose.axis, d.pose.degrees)),
      place_(vector(d.pose.translate)),
      velocity_(vector(d.velocity)) {
  std::vector<Box> boxes;
  for (const uint32_t v : d.mesh->triangles) {
    if (corners_.size() % 3 == 0) boxes.emplace_back();
    corners_.push_back(d.scale * vector(d.mesh->positions[v]));
    boxes.back().add(corners_.back());
    box_.add(corners_.back());
  }
  measure();
  find_edges();
  triangle_grid_.fill(box_, boxes);
  boxes.clear();
  for (const Edge& edge : edges_) {
    boxes.emplace_back().add(edge.a);
    boxes.back().add(edge.b);
  }
  edge_grid_.fill(box_, boxes);
}

void Ridges::measure() {
  double area = 0, volume = 0;
  for (size_t c = 0; c + 2 < corners_.size(); c += 3) {
    const Vector3d a = corners_[c] - box_.center();
    const Vector3d across = (corners_[c + 1] - corners_[c]).cross(corners_[c + 2] - corners_[c]);
    area += across.norm() / 2;
    volume += a.dot(across) / 6;
  }
  most_hidden_ = area > 0 ? 0.2 * 3 * std::max(volume, 0.0) / area : 0;
}

void Ridges::find_edges() {
  const std::vector<uint32_t> number = welded(corners_);
  std::vector<Side> sides;
  for (uint32_t c = 0; c < corners_.size(); ++c) {
    const uint32_t i = number[c], j = number[next_corner(c)];
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
    const Vector3d a = corners_[sides[i].corner], b = corners_[next_corner(sides[i].corner)];
    if (end - i == 2) {
      const Vector3d other = corners_[next_corner(next_corner(sides[i + 1].corner))] - a;
      if (!(normal_of(sides[i]).dot(other) < -1e-9 * other.norm())) continue;  // flat or concave
    }
    const double flat = sum.norm() / double(end - i);
    edges_.push_back({a, b, flat > 1e-6 ? Vector3d(sum.normalized()) : Vector3d(0, 0, 0), flat});
  }
}

void Ridges::Grid::fill(const Box& all, const std::vector<Box>& boxes) {
  constexpr double most_cells = 64;
  const Vector3d size = all.high - all.low;
  low_ = all.low;
  cell_ = std::max(size.maxCoeff() / most_cells, 1e-300);
  size_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int cells = int(std::min(size[axis] / cell_, most_cells)) + 1;
    cells_[size_t(axis)] = cells;
    count *= size_t(cells);
  }
  start_.assign(count + 1, 0);
  for (const Box& box : boxes) {
    any_cell(cells_of(box), [&](size_t cell) { return ++start_[cell + 1] == 0; });
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  numbers_.resize(start_.back());
  std::vector<uint32_t> next(start_.begin(), start_.end() - 1);
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    any_cell(cells_of(boxes[i]), [&](size_t cell) {
      numbers_[next[cell]++] = i;
      return false;
    });
  }
}

Ridges::Grid::Range Ridges::Grid::cells_of(const Box& box) const {
  Range range;
  for (int axis = 0; axis < 3; ++axis) {
    const double most = cells_[size_t(axis)];
    const auto cell = [&](double x) {
      return std::clamp(std::floor((x - low_[axis]) / cell_), -1.0, most);
    };
    range[size_t(axis)] = {std::max(int(cell(box.low[axis])), 0),
                           std::min(int(cell(box.high[axis])), int(most) - 1)};
  }
  return range;
}

template <class Use>
bool Ridges::Grid::any_cell(const Range& r, Use use) const {
  for (int k = r[2][0]; k <= r[2][1]; ++k) {
    for (int j = r[1][0]; j <= r[1][1]; ++j) {
      for (int i = r[0][0]; i <= r[0][1]; ++i) {
        if (use((size_t(k) * size_t(cells_[1]) + size_t(j)) * size_t(cells_[0]) + size_t(i))) {
          return true;
        }
      }
    }
  }
  return false;
}

template <class Use>
bool Ridges::Grid::any_near(const Box& box, Use use) const {
  return any_cell(cells_of(box), [&](size_t cell) {
    for (uint32_t k = start_[cell]; k < start_[cell + 1]; ++k) {
      if (use(numbers_[k])) return true;
    }
    return false;
  });
}

bool Ridges::crosses(const Vector3d& from, const Vector3d& to, double least) const {
  const Vector3d way = to - from;
  Box around;
  around.add(from);
  around.add(to);
  return triangle_grid_.any_near(around, [&](uint32_t triangle) {
    const double at = crossing(&corners_[3 * size_t(triangle)], from, way);
    return at <= 1 && at * way.norm() > least;
  });
}

Vector3d Ridges::local(const Vector3d& point, double time) const {
  return turn_.transpose() * (point - place_ - velocity_ * time);
}

void Ridges::add(const std::array<Vector3d, 3>& corners, double time, Found& found) const {
  std::array<Vector3d, 3> t;
  Box around;
  for (size_t i = 0; i < 3; ++i) {
    t[i] = local(corners[i], time);
    around.add(t[i]);
  }
  double longest = 0;
  for (size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, (t[(i + 1) % 3] - t[i]).norm());
    if (!found.cut) found.cut = crosses(t[i], t[(i + 1) % 3], 0);
  }
  // No point of a triangle is farther from the nearest corner, which is outside.
  const double most = longest / std::sqrt(3.0);
  edge_grid_.any_near(around.grown(1.5 * most), [&](uint32_t number) {
    look_below(edges_[number], t, most, found);
    return false;
  });
}

/// Below an edge, depth is the distance to the nearer of its two faces. It is greatest halfway
/// between them: at an end of the line in which that plane cuts the triangle.
void Ridges::look_below(const Edge& edge, const std::array<Vector3d, 3>& t, double most,
                        Found& found) const {
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
  if (count < 2) return;
  // From 0 to 1 along the edge, and how far below it.
  std::array<double, 2> at, below;
  for (size_t k = 0; k < 2; ++k) {
    at[k] = along.dot(ends[k] - edge.a) / along.squaredNorm();
    below[k] = -edge.out.dot(ends[k] - edge.a);
  }
  if ((below[0] < 0) != (below[1] < 0)) {
    const double level = below[0] / (below[0] - below[1]);
    const double where = at[0] + level * (at[1] - at[0]);
    found.cut |= where >= 0 && where <= 1;
  }
  if (!closed_) return;
  for (size_t k = 0; k < 2; ++k) {
    const double end = std::clamp(at[k], 0.0, 1.0), other = at[1 - k];
    if (end != at[k] && (other - end) * (end - at[k]) < 0) continue;  // all beyond the edge's end
    const double part = end == at[k] ? 0 : (end - at[k]) / (other - at[k]);
    const double deep = below[k] + part * (below[1 - k] - below[k]);
    const double depth = std::min(deep * edge.flat, most);
    if (!(depth > found.depth) || deep * edge.flat > 1.01 * most) continue;
    const Vector3d top = edge.a + end * along;
    // A crossing in between: the triangle is beyond what is below the edge.
    if (!crosses(top, top - deep * edge.out, 1e-6 * box_.radius())) found.depth = depth;
  }
}

std::vector<Vector3d> shrunk(const io::Mesh& mesh, double by) {
  std::vector<Vector3d> points;
  for (const double3& p : mesh.positions) points.push_back(vector(p));
  if (by == 0) return points;
  const std::vector<uint32_t> number = welded(points);
  std::vector<Vector3d> out(points.size(), Vector3d::Zero());
  std::vector<double> least(points.size(), 1);
  const auto each_corner = [&](auto use) {
    for (size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
      const uint32_t* v = &mesh.triangles[t];
      for (size_t k = 0; k < 3; ++k) {
        const Vector3d a = points[v[(k + 1) % 3]] - points[v[k]],
                       b = points[v[(k + 2) % 3]] - points[v[k]];
        const Vector3d area = a.cross(b);
        const double angle = std::atan2(area.norm(), a.dot(b));
        if (area.norm() > 0) use(number[v[k]], Vector3d(area.normalized()), angle);
      }
    }
  };
  each_corner([&](uint32_t v, const Vector3d& normal, double angle) { out[v] += angle * normal; });
  for (Vector3d& n : out) n.normalize();
  each_corner([&](uint32_t v, const Vector3d& normal, double) {
    least[v] = std::min(least[v], normal.dot(out[v]));
  });
  std::vector<Vector3d> moved = points;
  for (size_t v = 0; v < points.size(); ++v) {
    moved[v] -= by / std::max(least[number[v]], 0.4) * out[number[v]];
  }
  return moved;
}

// By the triangles that a ray in an odd direction goes through.
bool Ridges::enclose(const Vector3d& point, double time) const {
  const Vector3d from = local(point, time), way(0.3172, 0.5271, 0.7883);
  size_t crossed = 0;
  for (size_t c = 0; c + 2 < corners_.size(); c += 3) {
    crossed += crossing(&corners_[c], from, way) < never;
  }
  return crossed % 2 == 1;
}

}  // namespace weft::render
