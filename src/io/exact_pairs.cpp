#include "io/exact_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace weft::io {
namespace {

constexpr size_t leaf_size = 12;

double square_of(double x, double y, double z) { return (x * x + y * y) + z * z; }

struct PointBox {
  double3 low, high;
};

PointBox box_of(const double3* points, size_t count) {
  PointBox box{points[0], points[0]};
  for (size_t i = 1; i < count; ++i) {
    const double3& p = points[i];
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

double gap(double low_a, double high_a, double low_b, double high_b) {
  return std::max({low_b - high_a, low_a - high_b, 0.0});
}
double span(double low_a, double high_a, double low_b, double high_b) {
  return std::max(high_b - low_a, high_a - low_b);
}

// Rounded differences, products and sums grow with what they are made of: the square of a pair lies
// between these two to the last bit, and no margin is needed.
double least_square(const PointBox& a, const PointBox& b) {
  return square_of(gap(a.low.x, a.high.x, b.low.x, b.high.x),
                   gap(a.low.y, a.high.y, b.low.y, b.high.y),
                   gap(a.low.z, a.high.z, b.low.z, b.high.z));
}
double most_square(const PointBox& a, const PointBox& b) {
  return square_of(span(a.low.x, a.high.x, b.low.x, b.high.x),
                   span(a.low.y, a.high.y, b.low.y, b.high.y),
                   span(a.low.z, a.high.z, b.low.z, b.high.z));
}

/// Points in the order of a tree that halves its longest side; node i has the children 2i+1, 2i+2.
class Tree {
 public:
  struct Node {
    size_t begin, end;
    PointBox box;
    bool leaf;
  };

  explicit Tree(const std::vector<double3>& positions) : vertices(positions.size()) {
    std::iota(vertices.begin(), vertices.end(), 0u);
    points.resize(positions.size());
    if (!positions.empty()) build(positions, 0, 0, positions.size());
  }
  bool empty() const { return points.empty(); }

  std::vector<double3> points;
  std::vector<uint32_t> vertices;  ///< of the points
  std::vector<Node> nodes;

 private:
  void build(const std::vector<double3>& positions, size_t node, size_t begin, size_t end) {
    if (nodes.size() <= node) nodes.resize(2 * node + 1);
    for (size_t i = begin; i < end; ++i) points[i] = positions[vertices[i]];
    const PointBox box = box_of(&points[begin], end - begin);
    const bool leaf = end - begin <= leaf_size;
    nodes[node] = {begin, end, box, leaf};
    if (leaf) return;
    const double3 side{box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z};
    const double longest = std::max({side.x, side.y, side.z});
    const auto axis = longest == side.x   ? &double3::x
                      : longest == side.y ? &double3::y
                                          : &double3::z;
    const size_t middle = begin + (end - begin) / 2;
    const auto at = [&](size_t i) { return vertices.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](uint32_t a, uint32_t b) {
      return positions[a].*axis < positions[b].*axis;
    });
    build(positions, 2 * node + 1, begin, middle);
    build(positions, 2 * node + 2, middle, end);
  }
};

/// Descends two trees, or one with itself. Tell: all(a, b) of nodes whose points are all near, and
/// one(i, j) of two points.
template <class Tell>
class Descent {
 public:
  Descent(const Tree& a, const Tree& b, double distance, Tell& tell)
      : a_(a), b_(b), same_(&a == &b), square_(distance * distance), tell_(tell) {
    if (!a.empty() && !b.empty()) visit(0, 0);
  }

 private:
  void visit(size_t a, size_t b) {
    const Tree::Node &n = a_.nodes[a], &m = b_.nodes[b];
    if (!(least_square(n.box, m.box) < square_)) return;
    const bool itself = same_ && a == b;
    if (most_square(n.box, m.box) < square_ && tell_.all(n, m, itself)) return;
    if (n.leaf && m.leaf) return compare(n, m, itself);
    if (itself) {
      visit(2 * a + 1, 2 * a + 1);
      visit(2 * a + 2, 2 * a + 2);
      visit(2 * a + 1, 2 * a + 2);
    } else if (m.leaf || (!n.leaf && n.end - n.begin >= m.end - m.begin)) {
      visit(2 * a + 1, b);
      visit(2 * a + 2, b);
    } else {
      visit(a, 2 * b + 1);
      visit(a, 2 * b + 2);
    }
  }

  void compare(const Tree::Node& n, const Tree::Node& m, bool itself) {
    for (size_t i = n.begin; i < n.end; ++i) {
      const double3 p = a_.points[i];
      for (size_t j = itself ? i + 1 : m.begin; j < m.end; ++j) {
        const double3 q = b_.points[j];
        if (square_of(p.x - q.x, p.y - q.y, p.z - q.z) < square_) tell_.one(i, j);
      }
    }
  }

  const Tree &a_, &b_;
  bool same_;
  double square_;
  Tell& tell_;
};

struct Counter {
  uint64_t count = 0;

  bool all(const Tree::Node& n, const Tree::Node& m, bool itself) {
    const uint64_t a = n.end - n.begin, b = m.end - m.begin;
    count += itself ? a * (a - 1) / 2 : a * b;
    return true;
  }
  void one(size_t, size_t) { ++count; }
};

struct Teller {
  const Tree &a, &b;
  uint32_t cloth_a, cloth_b;
  const std::function<void(const MeetingPair&)>& take;

  bool all(const Tree::Node&, const Tree::Node&, bool) { return false; }
  void one(size_t i, size_t j) {
    uint32_t v = a.vertices[i], w = b.vertices[j];
    if (cloth_a == cloth_b && v > w) std::swap(v, w);
    take({cloth_a, v, cloth_b, w});
  }
};

void require_finite(const std::vector<MeetingCloth>& cloths) {
  for (size_t c = 0; c < cloths.size(); ++c) {
    for (size_t v = 0; v < cloths[c].positions.size(); ++v) {
      const double3& p = cloths[c].positions[v];
      if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
      throw std::invalid_argument("vertex " + std::to_string(v) + " of cloth " + std::to_string(c) +
                                  " is not finite (it has no neighbours) give a place");
    }
  }
}

/// Calls use(tree, tree, cloth, cloth, distance) for cloths that meet.
template <class Use>
void each_meeting(const std::vector<MeetingCloth>& cloths, Use use) {
  require_finite(cloths);
  std::vector<Tree> trees;
  trees.reserve(cloths.size());
  for (const MeetingCloth& cloth : cloths) trees.emplace_back(cloth.positions);
  for (size_t i = 0; i < cloths.size(); ++i) {
    for (size_t j = i; j < cloths.size(); ++j) {
      const double distance = meeting_distance(cloths[i], cloths[j], i == j);
      if (distance > 0) use(trees[i], trees[j], uint32_t(i), uint32_t(j), distance);
    }
  }
}

}  // namespace

double meeting_distance(const MeetingCloth& a, const MeetingCloth& b, bool same) {
  if (same) return a.itself ? a.distance : 0;
  if (!a.others || !b.others || (a.layers & b.layers) == 0) return 0;
  return 0.5 * (a.distance + b.distance);
}

bool are_nearer(double3 a, double3 b, double distance) {
  return square_of(a.x - b.x, a.y - b.y, a.z - b.z) < distance * distance;
}

uint64_t count_near_pairs(const std::vector<MeetingCloth>& cloths) {
  Counter counter;
  each_meeting(cloths, [&](const Tree& a, const Tree& b, uint32_t, uint32_t, double distance) {
    const Descent descent(a, b, distance, counter);
  });
  return counter.count;
}

void each_near_pair(const std::vector<MeetingCloth>& cloths,
                    const std::function<void(const MeetingPair&)>& take) {
  each_meeting(cloths, [&](const Tree& a, const Tree& b, uint32_t i, uint32_t j, double distance) {
    Teller teller{a, b, i, j, take};
    const Descent descent(a, b, distance, teller);
  });
}

std::vector<MeetingPair> list_near_pairs(const std::vector<MeetingCloth>& cloths) {
  std::vector<MeetingPair> pairs;
  each_near_pair(cloths, [&](const MeetingPair& pair) { pairs.push_back(pair); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace weft::io
