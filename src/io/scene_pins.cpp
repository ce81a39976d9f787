// The key "pins": vertex indices, or groups of vertices, rows, columns and corners with a motion.
#include "io/scene_parts.h"

#include <algorithm>

namespace weft::io {
namespace {

bool equal(double3 a, double3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
bool equal(const PinMotion& a, const PinMotion& b) {
  return equal(a.velocity, b.velocity) && equal(a.amplitude, b.amplitude) && a.omega == b.omega;
}

class PinReader {
 public:
  explicit PinReader(ClothScene& cloth)
      : cloth_(cloth),
        grid_(std::get_if<GridShape>(&cloth.shape)),
        vertices_(vertex_count(cloth.shape)) {}

  void read(const Node& pins) {
    const size_t count = pins.array_size("an array of pins");
    for (size_t i = 0; i < count; ++i) {
      const Node entry = pins[i];
      if (entry.is_object())
        read_group(entry);
      else
        add(entry, entry.index(vertices_, "vertices"), Pin::fixed);
    }
    finish(pins);
  }

 private:
  // A row is short to name and long to hold.
  void add(const Node& node, uint32_t vertex, uint32_t motion) {
    if (cloth_.pins.size() == 4 * uint64_t(vertices_) + 1000) {
      node.fail("pins vertices that were named four times each before (there are " +
                std::to_string(vertices_) + ") leave out what is repeated");
    }
    cloth_.pins.push_back({vertex, motion});
  }

  void read_group(const Node& group) {
    group.require_object({"vertices", "rows", "columns", "corners", "motion"});
    uint32_t motion = Pin::fixed;
    if (const auto node = group.find("motion")) motion = read_motion(*node);
    if (const auto node = group.find("vertices")) {
      const size_t count = node->array_size("an array of vertex indices");
      for (size_t i = 0; i < count; ++i) {
        add(*node, (*node)[i].index(vertices_, "vertices"), motion);
      }
    }
    if (const auto node = group.find("rows")) read_rows(*node, motion);
    if (const auto node = group.find("columns")) read_columns(*node, motion);
    if (const auto node = group.find("corners")) {
      if (node->boolean()) add_corners(*node, motion);
    }
  }

  uint32_t read_motion(const Node& node) {
    node.require_object({"velocity", "amplitude", "omega"});
    PinMotion motion;
    if (const auto key = node.find("velocity")) motion.velocity = key->vector();
    if (const auto key = node.find("amplitude")) motion.amplitude = key->vector();
    if (const auto key = node.find("omega")) motion.omega = key->number();
    cloth_.motions.push_back(motion);
    return uint32_t(cloth_.motions.size() - 1);
  }

  void require_grid(const Node& node) const {
    if (!grid_)
      node.fail("needs a grid (other shapes have no rows, columns or corners) use \"vertices\"");
  }

  void read_rows(const Node& node, uint32_t motion) {
    const size_t count = node.array_size("an array of row numbers");
    if (count > 0) require_grid(node);
    for (size_t i = 0; i < count; ++i) {
      const uint32_t row = node[i].index(grid_->rows, "rows");
      for (uint32_t c = 0; c < grid_->columns; ++c) add(node, row * grid_->columns + c, motion);
    }
  }
  void read_columns(const Node& node, uint32_t motion) {
    const size_t count = node.array_size("an array of column numbers");
    if (count > 0) require_grid(node);
    for (size_t i = 0; i < count; ++i) {
      const uint32_t column = node[i].index(grid_->columns, "columns");
      for (uint32_t r = 0; r < grid_->rows; ++r) add(node, r * grid_->columns + column, motion);
    }
  }
  void add_corners(const Node& node, uint32_t motion) {
    require_grid(node);
    const uint32_t last_row = (grid_->rows - 1) * grid_->columns;
    for (const uint32_t vertex :
         {0u, grid_->columns - 1, last_row, last_row + grid_->columns - 1}) {
      add(node, vertex, motion);
    }
  }

  bool same_motion(const Pin& a, const Pin& b) const {
    const PinMotion still;
    const auto& motions = cloth_.motions;
    return equal(a.motion == Pin::fixed ? still : motions[a.motion],
                 b.motion == Pin::fixed ? still : motions[b.motion]);
  }

  // Groups may overlap (a row and the corners) as long as they agree.
  void finish(const Node& pins) {
    auto& all = cloth_.pins;
    std::stable_sort(all.begin(), all.end(),
                     [](const Pin& a, const Pin& b) { return a.vertex < b.vertex; });
    for (size_t i = 1; i < all.size(); ++i) {
      if (all[i].vertex == all[i - 1].vertex && !same_motion(all[i], all[i - 1])) {
        pins.fail("vertex " + std::to_string(all[i].vertex) +
                  " is pinned twice with different motions (it can follow one) remove one of them");
      }
    }
    const auto end = std::unique(all.begin(), all.end(),
                                 [](const Pin& a, const Pin& b) { return a.vertex == b.vertex; });
    all.erase(end, all.end());
  }

  ClothScene& cloth_;
  const GridShape* grid_;
  uint32_t vertices_;
};

}  // namespace

void read_pins(const Node& node, ClothScene& cloth) { PinReader(cloth).read(node); }

}  // namespace weft::io
