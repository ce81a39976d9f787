// How often the pieces of a closed surface go round a point.
#pragma once

#include "base/host_memory.h"

#include "scene/collider_mesh_parts.h"

namespace weft::scene {

/// A point, asked of all pieces but its own.
struct Probe {
  Point at;
  uint32_t triangle, piece;
  int turns;  ///< counted: 1 inside a piece, -1 inside a cavity alone, 0 outside
};

/// Counts where rays along x leave through triangles, minus where they enter. Only comparisons of
/// sums and products decide, in one order for both triangles of an edge: no ray slips through.
class Winding {
 public:
  void add(const Probe& probe) { probes_.push_back(probe); }
  bool empty() const { return probes_.empty(); }
  /// `piece_of`: by triangle.
  void count(const Surface&, const Vector<uint32_t>& piece_of);
  /// In the order in which they came.
  const Vector<Probe>& probes() const { return probes_; }

 private:
  void sort_into_cells();
  size_t column(double y) const { return cell(y, low_y_, size_y_); }
  size_t row(double z) const { return cell(z, low_z_, size_z_); }
  size_t cell(double at, double low, double size) const;

  Vector<Probe> probes_;
  Vector<uint32_t> start_, listed_;  ///< probes by cell of a grid across the rays
  size_t cells_ = 1;                 ///< of a side of it
  double low_y_ = 0, low_z_ = 0, size_y_ = 0, size_z_ = 0;
};

}  // namespace weft::scene
