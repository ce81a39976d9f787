#include "scene/near_rest_pairs.h"

#include <algorithm>
#include <cmath>

namespace weft::scene {

namespace {

constexpr size_t most_of_leaf = 16;

/// A binary tree of boxes about the points, cut across their longest side. Rounding keeps the order
/// of differences and sums, so that what is said of a box is said of its points to the last bit.
class PairCounter {
 public:
  PairCounter(const CookedFabric& fabric, double distance)
      : distance2_(distance * distance), points_(fabric.vertices) {
    for (uint32_t v = 0; v < fabric.vertices; ++v) points_[v] = fabric.position_of(v);
    boxes_.reserve(4 * points_.size() / most_of_leaf + 2);
    if (!points_.empty()) grow(0, points_.size());
  }

  uint64_t count() const { return boxes_.empty() ? 0 : within(0); }

 private:
  struct Box {
    double3 low, high;
    size_t first, end;
    uint32_t left, right;  ///< 0: a leaf
  };

  uint32_t grow(size_t first, size_t end) {
    const auto number = static_cast<uint32_t>(boxes_.size());
    Box box{points_[first], points_[first], first, end, 0, 0};
    for (size_t i = first; i < end; ++i) {
      const double3& p = points_[i];
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
    boxes_.push_back(box);
    const double size[3] = {box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z};
    const double* longest = std::max_element(size, size + 3);
    if (end - first <= most_of_leaf || !(*longest > 0)) return number;
    double double3::*const axis = longest == size       ? &double3::x
                                  : longest == size + 1 ? &double3::y
                                                        : &double3::z;
    const size_t middle = first + (end - first) / 2;
    const auto at = [&](size_t i) { return points_.begin() + ptrdiff_t(i); };
    std::nth_element(at(first), at(middle), at(end),
                     [axis](const double3& a, const double3& b) { return a.*axis < b.*axis; });
    const uint32_t left = grow(first, middle), right = grow(middle, end);
    boxes_[number].left = left;
    boxes_[number].right = right;
    return number;
  }

  static double gap(double low, double high, double other_low, double other_high) {
    return std::max({0.0, other_low - high, low - other_high});
  }
  static double span(double low, double high, double other_low, double other_high) {
    return std::max(other_high - low, high - other_low);
  }
  static double squares(double x, double y, double z) { return x * x + y * y + z * z; }

  bool all_near(const Box& a, const Box& b) const {
    return squares(span(a.low.x, a.high.x, b.low.x, b.high.x),
                   span(a.low.y, a.high.y, b.low.y, b.high.y),
                   span(a.low.z, a.high.z, b.low.z, b.high.z)) < distance2_;
  }
  bool all_far(const Box& a, const Box& b) const {
    return squares(gap(a.low.x, a.high.x, b.low.x, b.high.x),
                   gap(a.low.y, a.high.y, b.low.y, b.high.y),
                   gap(a.low.z, a.high.z, b.low.z, b.high.z)) >= distance2_;
  }
  bool near(const double3& a, const double3& b) const {
    return squares(a.x - b.x, a.y - b.y, a.z - b.z) < distance2_;
  }

  uint64_t within(uint32_t number) const {
    const Box& box = boxes_[number];
    const uint64_t points = box.end - box.first;
    if (all_near(box, box)) return points * (points - 1) / 2;
    if (box.left != 0) return within(box.left) + within(box.right) + between(box.left, box.right);
    uint64_t count = 0;
    for (size_t i = box.first; i < box.end; ++i) {
      for (size_t j = i + 1; j < box.end; ++j) count += near(points_[i], points_[j]) ? 1 : 0;
    }
    return count;
  }

  uint64_t between(uint32_t one, uint32_t other) const {
    const Box &a = boxes_[one], &b = boxes_[other];
    if (all_far(a, b)) return 0;
    if (all_near(a, b)) return uint64_t(a.end - a.first) * (b.end - b.first);
    const bool cut_a = a.left != 0 && (b.left == 0 || a.end - a.first >= b.end - b.first);
    if (cut_a) return between(a.left, other) + between(a.right, other);
    if (b.left != 0) return between(one, b.left) + between(one, b.right);
    uint64_t count = 0;
    for (size_t i = a.first; i < a.end; ++i) {
      for (size_t j = b.first; j < b.end; ++j) count += near(points_[i], points_[j]) ? 1 : 0;
    }
    return count;
  }

  double distance2_;
  Vector<double3> points_;
  Vector<Box> boxes_;
};

}  // namespace

uint64_t near_rest_pairs(const CookedFabric& fabric, double distance) {
  return PairCounter(fabric, distance).count();
}

}  // namespace weft::scene
