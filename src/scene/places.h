// Points that are nearer to each other than a distance, and so are one place.
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>

#include "base/host_memory.h"
#include "weft/core.hpp"

namespace weft::scene {

/// Every point joins the first place nearer than `distance`, in the order in which points come.
class Places {
 public:
  /// Cells at least as wide as the distance; where points are hardly ever that near, much wider
  /// ones take fewer looks.
  Places(double distance, double cell) : distance_(distance), cell_(cell) {}

  /// The number of a point's place.
  uint32_t of(const double3& x);
  uint32_t count() const { return static_cast<uint32_t>(places_.size()); }
  /// Where they are: at their first points.
  Vector<double3>& positions() { return places_; }

 private:
  struct Cell {
    int64_t x, y, z;
    friend bool operator==(const Cell& a, const Cell& b) {
      return a.x == b.x && a.y == b.y && a.z == b.z;
    }
  };
  struct CellHash {
    size_t operator()(const Cell& c) const;
  };
  static constexpr uint32_t none = ~0u;

  Cell cell_of(double x, double y, double z) const;

  double distance_, cell_;
  Vector<double3> places_;
  Vector<uint32_t> next_;  ///< the place before it in its cell
  std::unordered_map<Cell, uint32_t, CellHash, std::equal_to<Cell>,
                     HostAllocator<std::pair<const Cell, uint32_t>>>
      last_;
};

}  // namespace weft::scene
