#include "render/box_tree.h"

#include <algorithm>
#include <numeric>

namespace weft::render {

// Each node's things are halved at the middle one along the direction in which they spread most.
BoxTree::BoxTree(const std::vector<Box>& boxes) : numbers_(boxes.size()) {
  if (boxes.empty()) return;
  std::iota(numbers_.begin(), numbers_.end(), 0u);
  nodes_.push_back({{}, 0, uint32_t(boxes.size())});
  for (size_t n = 0; n < nodes_.size(); ++n) {
    const uint32_t first = nodes_[n].first, count = nodes_[n].count;
    const auto begin = numbers_.begin() + first;
    Box all, centers;
    std::for_each_n(begin, count, [&](uint32_t i) {
      all.add(boxes[i]);
      centers.add(boxes[i].center());
    });
    nodes_[n].box = all;
    if (count <= leaf) continue;
    Eigen::Index axis = 0;
    (centers.high - centers.low).maxCoeff(&axis);
    std::nth_element(begin, begin + count / 2, begin + count, [&](uint32_t i, uint32_t j) {
      const double a = boxes[i].center()[axis], b = boxes[j].center()[axis];
      return a < b || (a == b && i < j);
    });
    nodes_[n].first = uint32_t(nodes_.size());
    nodes_[n].count = 0;
    nodes_.push_back({{}, first, count / 2});
    nodes_.push_back({{}, first + count / 2, count - count / 2});
  }
  boxes_.reserve(boxes.size());
  for (const uint32_t i : numbers_) boxes_.push_back(boxes[i]);
}

}  // namespace weft::render
