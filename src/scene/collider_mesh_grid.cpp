// The grid is cut in halves down to single cells. A box takes from the list of the box around it
// the triangles that can be nearest to one of its points:
//
//   no farther from its centre than the nearest one and its diagonal, and
//   not dominated: triangle B dominates A if it is nearer at every corner of the box than A's
//   distance, continued linearly from the centre. Distances to triangles are convex: A is then
//   nowhere nearer than the linear one, and B in the box nowhere farther than between corners.
//
// So a list holds about the triangles below a cell, however large the thickness.
#include <algorithm>
#include <cmath>

#include "base/message_host.h"
#include "scene/collider_mesh_parts.h"

namespace weft::scene {

using namespace WEFT_BACKEND_NS;

namespace {

/// As in state/collider_mesh.h.
constexpr int32_t no_list = -1, deep_inside = -2;
constexpr double cells_per_triangle = 3;  ///< near the mesh: more are faster and take more memory
constexpr int64_t least_cells = 4096, most_cells = int64_t(16) << 20;
constexpr int most_cells_along = 4096;  ///< so that a float tells one cell from the next

struct Candidate {
  int32_t triangle;
  double distance;  ///< from the centre of the box
  Point gradient;   ///< of the distance there
};

/// Cells [low, high) along every axis.
struct Box {
  int low[3], high[3];
  int64_t size() const {
    return int64_t(high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
  }
};

class GridBuilder {
 public:
  explicit GridBuilder(CookedColliderMesh& mesh) : mesh_(mesh) {}

  void choose_cells();
  void fill();

 private:
  void descend(const Box&, const Vector<Candidate>& around, Point around_centre, size_t depth);
  double measure(const Vector<Candidate>& around, Point way, double diagonal, Point centre,
                 Vector<Candidate>& list) const;
  Candidate measured(int32_t triangle, Point centre) const;
  void drop_dominated(Vector<Candidate>& list, Point centre, Point half, int rounds);
  bool is_inside(int32_t triangle, Point x) const;
  void store_list(const Box&, Vector<Candidate>& list);
  void store_deep(const Box&, int32_t triangle);
  void renumber();
  size_t cell_number(int i, int j, int k) const {
    return (size_t(k) * size_t(mesh_.cells[1]) + size_t(j)) * size_t(mesh_.cells[0]) + size_t(i);
  }

  CookedColliderMesh& mesh_;
  double slack_ = 0;  ///< of a position in float within the grid
  Vector<Vector<Candidate>> lists_;
};

/// Through memory: g++ 12 drops the round trip of two neighbouring numbers at -O2.
double rounded(double x) {
  const volatile float narrow = static_cast<float>(x);
  return static_cast<double>(narrow);
}

/// Edge of the cells such that about `wanted` of them lie within reach of a surface of that area.
double size_for(double area, double thickness, double wanted) {
  double low = 0, high = 1e12;
  for (int round = 0; round < 200; ++round) {
    const double size = 0.5 * (low + high);
    const double reached = area * 2 * (thickness + 0.87 * size);
    (reached > wanted * size * size * size ? low : high) = size;
  }
  return high;
}

void GridBuilder::choose_cells() {
  Point low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  double area = 0;
  for (uint32_t t = 0; t < mesh_.triangles; ++t) {
    Point c[3];
    for (int i = 0; i < 3; ++i) {
      c[i] = corner_of(mesh_, t, i);
      low = {std::min(low.x, c[i].x), std::min(low.y, c[i].y), std::min(low.z, c[i].z)};
      high = {std::max(high.x, c[i].x), std::max(high.y, c[i].y), std::max(high.z, c[i].z)};
    }
    area += 0.5 * length(cross(c[1] - c[0], c[2] - c[0]));
  }
  const double far = std::max({-low.x, -low.y, -low.z, high.x, high.y, high.z});
  const double margin = 1.001 * mesh_.thickness + 1e-6 * far;
  const Point pad{margin, margin, margin};
  low = low - pad;
  high = high + pad;
  mesh_.zone_low = {low.x, low.y, low.z};
  mesh_.zone_high = {high.x, high.y, high.z};

  const double extent[3] = {high.x - low.x, high.y - low.y, high.z - low.z};
  const double longest = std::max({extent[0], extent[1], extent[2]});
  const double wanted = std::max(cells_per_triangle * mesh_.triangles, double(least_cells));
  double size = std::max({size_for(area, mesh_.thickness, wanted), mesh_.thickness / 4,
                          longest / (most_cells_along - 2)});
  const double most = std::min(16 * wanted, double(most_cells));
  const auto cells = [&](int axis) { return std::floor(extent[axis] / size) + 1; };
  while (cells(0) * cells(1) * cells(2) > most) size *= 1.02;
  mesh_.cell_size = rounded(size * (1 + 1e-6));
  mesh_.grid_low = {rounded(low.x), rounded(low.y), rounded(low.z)};
  for (int axis = 0; axis < 3; ++axis) mesh_.cells[axis] = int32_t(cells(axis));
  slack_ = 1e-6 * longest;
}

Candidate GridBuilder::measured(int32_t triangle, Point centre) const {
  const NearestPoint near = nearest_point(&mesh_.corners[size_t(triangle) * 9], centre);
  const Point away = centre - near.point;
  const double distance = length(away);
  return {triangle, distance, (distance > 0 ? 1 / distance : 0) * away};
}

/// Fills `list` with those that can be nearest somewhere in the box; returns the least distance.
double GridBuilder::measure(const Vector<Candidate>& around, Point way, double diagonal,
                            Point centre, Vector<Candidate>& list) const {
  const auto bound = [&](const Candidate& c) { return c.distance + dot(c.gradient, way); };
  size_t first = 0;
  for (size_t c = 1; c < around.size(); ++c) {
    if (bound(around[c]) < bound(around[first])) first = c;
  }
  double least = measured(around[first].triangle, centre).distance;
  const double farthest = mesh_.closed ? 1e300 : mesh_.thickness + 0.5 * diagonal + slack_;
  list.clear();
  for (const Candidate& c : around) {
    if (bound(c) > std::min(least + diagonal, farthest)) continue;
    list.push_back(measured(c.triangle, centre));
    least = std::min(least, list.back().distance);
  }
  const double limit = std::min(least + diagonal, farthest);
  std::erase_if(list, [&](const Candidate& c) { return c.distance > limit; });
  return least;
}

/// The nearest candidates, one per round, take away what they dominate.
void GridBuilder::drop_dominated(Vector<Candidate>& list, Point centre, Point half, int rounds) {
  const auto before = [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
  };
  for (size_t round = 0; round < size_t(rounds) && round + 1 < list.size(); ++round) {
    std::iter_swap(list.begin() + std::ptrdiff_t(round),
                   std::min_element(list.begin() + std::ptrdiff_t(round), list.end(), before));
    const double* corners = &mesh_.corners[size_t(list[round].triangle) * 9];
    double least[8], x[8], y[8], z[8];
    for (int c = 0; c < 8; ++c) {
      x[c] = c & 1 ? half.x : -half.x;
      y[c] = c & 2 ? half.y : -half.y;
      z[c] = c & 4 ? half.z : -half.z;
      const Point at = centre + Point{x[c], y[c], z[c]};
      least[c] = length(at - nearest_point(corners, at).point) + slack_;
    }
    const auto dominated = [&](const Candidate& a) {
      bool farther = true;
      for (int c = 0; c < 8; ++c) {
        const Point g = a.gradient;
        farther &= a.distance + g.x * x[c] + g.y * y[c] + g.z * z[c] > least[c];
      }
      return farther;
    };
    // The dominators so far cannot be taken away by one that is no nearer to the centre.
    list.erase(std::remove_if(list.begin() + std::ptrdiff_t(round) + 1, list.end(), dominated),
               list.end());
  }
}

bool GridBuilder::is_inside(int32_t triangle, Point x) const {
  const NearestPoint near = nearest_point(&mesh_.corners[size_t(triangle) * 9], x);
  const double* n = &mesh_.sides[size_t(triangle) * 18];
  const Point normal = near.feature < 0 ? normal_of(mesh_, uint32_t(triangle))
                                        : Point{n[3 * near.feature], n[3 * near.feature + 1],
                                                n[3 * near.feature + 2]};
  return dot(x - near.point, normal) < 0;
}

void GridBuilder::descend(const Box& box, const Vector<Candidate>& around, Point around_centre,
                          size_t depth) {
  const double size = mesh_.cell_size;
  const double3 low = mesh_.grid_low;
  const Point centre{low.x + 0.5 * size * (box.low[0] + box.high[0]),
                     low.y + 0.5 * size * (box.low[1] + box.high[1]),
                     low.z + 0.5 * size * (box.low[2] + box.high[2])};
  const Point half{0.5 * size * (box.high[0] - box.low[0]) + slack_,
                   0.5 * size * (box.high[1] - box.low[1]) + slack_,
                   0.5 * size * (box.high[2] - box.low[2]) + slack_};
  const double diagonal = 2 * length(half) + slack_;
  if (lists_.size() <= depth) lists_.resize(depth + 1);
  Vector<Candidate> list = std::move(lists_[depth]);
  const double least = measure(around, centre - around_centre, diagonal, centre, list);
  if (least > mesh_.thickness + 0.5 * diagonal + slack_) {
    if (mesh_.closed) {
      const auto near = std::min_element(
          list.begin(), list.end(),
          [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
      if (is_inside(near->triangle, centre)) store_deep(box, near->triangle);
    }
  } else if (box.size() == 1) {
    drop_dominated(list, centre, half, 3);
    store_list(box, list);
  } else {
    drop_dominated(list, centre, half, 1);
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
      if (box.high[a] - box.low[a] > box.high[axis] - box.low[axis]) axis = a;
    }
    Box lower = box, upper = box;
    lower.high[axis] = upper.low[axis] = (box.low[axis] + box.high[axis]) / 2;
    descend(lower, list, centre, depth + 1);
    descend(upper, list, centre, depth + 1);
  }
  lists_[depth] = std::move(list);
}

void GridBuilder::store_list(const Box& box, Vector<Candidate>& list) {
  std::sort(list.begin(), list.end(), [](const Candidate& a, const Candidate& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.triangle < b.triangle;
  });
  Array<int32_t>& entries = mesh_.entry_triangle;
  if (entries.size() + list.size() > INT32_MAX) {
    throw InvalidInput(
        "the collider mesh needs more than 2^31 list entries (too many of its triangles lie in one "
        "place) take away the double ones, or split it");
  }
  mesh_.cell_start[cell_number(box.low[0], box.low[1], box.low[2])] = int32_t(entries.size());
  for (const Candidate& c : list) entries.push_back(c.triangle);
  entries.back() = ~entries.back();
}

/// No point of the box is nearer than the thickness: one triangle leads out.
void GridBuilder::store_deep(const Box& box, int32_t triangle) {
  for (int k = box.low[2]; k < box.high[2]; ++k) {
    for (int j = box.low[1]; j < box.high[1]; ++j) {
      for (int i = box.low[0]; i < box.high[0]; ++i) {
        mesh_.cell_start[cell_number(i, j, k)] = deep_inside - triangle;
      }
    }
  }
}

/// Numbers the triangles as the lists come to them, so that those of a cell lie together.
void GridBuilder::renumber() {
  Vector<int32_t> number(mesh_.triangles, -1), old;
  old.reserve(mesh_.triangles);
  const auto numbered = [&](int32_t triangle) {
    int32_t& n = number[size_t(triangle)];
    if (n < 0) {
      n = int32_t(old.size());
      old.push_back(triangle);
    }
    return n;
  };
  for (int32_t& e : mesh_.entry_triangle) e = e < 0 ? ~numbered(~e) : numbered(e);
  for (int32_t t = 0; t < int32_t(mesh_.triangles); ++t) numbered(t);
  for (int32_t& c : mesh_.cell_start) {
    if (c <= deep_inside) c = deep_inside - numbered(deep_inside - c);
  }
  for (auto [values, per_triangle] :
       {std::pair{&mesh_.planes, size_t(16)}, std::pair{&mesh_.corners, size_t(9)},
        std::pair{&mesh_.sides, size_t(18)}}) {
    if (values->empty()) continue;
    const Vector<double> before(values->begin(), values->end());
    for (size_t t = 0; t < old.size(); ++t) {
      std::copy_n(before.begin() + std::ptrdiff_t(size_t(old[t]) * per_triangle), per_triangle,
                  values->begin() + std::ptrdiff_t(t * per_triangle));
    }
  }
}

void GridBuilder::fill() {
  const Box all{{0, 0, 0}, {mesh_.cells[0], mesh_.cells[1], mesh_.cells[2]}};
  mesh_.cell_start.assign(size_t(all.size()), no_list);
  Vector<Candidate> list(mesh_.triangles);
  for (uint32_t t = 0; t < mesh_.triangles; ++t) list[t] = {int32_t(t), 0, {0, 0, 0}};
  descend(all, list, {0, 0, 0}, 0);
  renumber();
}

}  // namespace

void build_grid(CookedColliderMesh& mesh) {
  GridBuilder builder(mesh);
  builder.choose_cells();
  builder.fill();
}

}  // namespace weft::scene
