// Finds what is near among many things with boxes.
#pragma once

#include "render/box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace weft::render {

/// A tree of boxes with four things in a leaf: about 90 bytes for each thing, wherever it reaches.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>&);

  /// Calls `use` with the number of each box that touches this one.
  template <class Use>
  void each_near(const Box& box, Use use) const {
    if (nodes_.empty()) return;
    std::array<uint32_t, most_waiting> waiting{0};
    for (size_t count = 1; count > 0;) {
      const Node& node = nodes_[waiting[--count]];
      if (!touch(node.box, box)) continue;
      if (node.count > 0) {
        for (uint32_t k = node.first; k < node.first + node.count; ++k) {
          if (touch(boxes_[k], box)) use(numbers_[k]);
        }
      } else {
        waiting[count++] = node.first;
        waiting[count++] = node.first + 1;
      }
    }
  }

 private:
  struct Node {
    Box box;
    uint32_t first = 0, count = 0;  ///< things in a leaf; else, without a count, two nodes
  };
  static constexpr uint32_t leaf = 4;
  static constexpr size_t most_waiting = 64;  ///< halves of at most 2^32 things, and one more

  static bool touch(const Box& a, const Box& b) {
    return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
  }

  std::vector<Node> nodes_;
  std::vector<Box> boxes_;  ///< in the order of the leaves
  std::vector<uint32_t> numbers_;
};

}  // namespace weft::render
