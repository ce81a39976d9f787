// Polygons to triangles, shared by the readers.
#pragma once

#include "weft/core.hpp"

#include "io/memory_limit.h"

#include <cstdint>
#include <string>
#include <vector>

namespace weft::io {

/// A polygon as a file lists it, which becomes `corners.size() - 2` triangles.
using Polygon = std::vector<uint32_t>;

/// Appends the fan (p0, p1, p2), (p0, p2, p3), ... of a polygon of at least three vertices: the
/// room of its triangles, and its corners until their positions are known. False when there is no
/// memory for it.
bool append_fan(const Polygon&, std::vector<uint32_t>& triangles, MemoryLimit&);
/// The polygon again, of `corners` vertices, from its fan.
void read_fan(const uint32_t* fan, size_t corners, Polygon&);

/// A vertex that a polygon of more than three vertices names twice; null when there is none.
/// (Triangles are the library's to judge.) Sorts the polygon.
const uint32_t* repeated_vertex(Polygon& scratch);

/// What came of cutting a polygon.
enum class Cut : uint8_t { done, no_memory, no_area, crossing, too_long };

/// Why it was not cut and what to do, after "the face".
std::string to_text(Cut, size_t corners);

/// Cuts polygons by ear clipping in the plane of their area (Meisters 1975; ElGindy, Everett and
/// Toussaint 1993). Where a polygon is flat and convex the cut is its fan from the corner with the
/// lowest number, else the ear with the shortest diagonal goes first: neither depends on the corner
/// that a file lists first. Corners on a line get no triangle without area while there is another
/// way; holes that are joined to the outline by a bridge of two coincident edges are left out.
/// Time follows the corners: what needs more than 500 comparisons for each is given up.
class PolygonCutter {
 public:
  explicit PolygonCutter(MemoryLimit& memory) : memory_(memory) {}

  /// `out` has room for 3 (polygon.size() - 2); it changes only when the polygon was cut.
  Cut cut(const std::vector<double3>& positions, const Polygon&, uint32_t* out);

 private:
  struct Flat {
    double x, y;  ///< in the polygon's plane, within 1 of zero
  };
  struct Ear {
    double diagonal;  ///< length squared, in space
    uint32_t tip, before, after;
  };
  /// How strictly ears are judged, in parts of the polygon's size.
  struct Rules {
    double flat;     ///< a corner lower than this has no area to speak of
    double outside;  ///< a corner further outside an ear does not block it
  };

  bool make_room(size_t corners);
  bool flatten(const std::vector<double3>& positions, const Polygon&);
  bool is_fan() const;
  bool crosses();
  bool crosses(uint32_t i, uint32_t j) const;
  Cut clip(uint32_t* out);
  bool clip_ears(Rules, uint32_t*& out);
  bool clip_flat(uint32_t*& out);
  void offer(uint32_t tip, Rules);
  void list_corners();
  bool is_cut(uint32_t corner) const { return after_[corner] == corner; }
  bool is_blocked(const Ear&, Rules);
  void remove(uint32_t tip, uint32_t*& out);
  double height(uint32_t a, uint32_t b, uint32_t c) const;
  double turn(uint32_t a, uint32_t b, uint32_t c) const;
  size_t cell(double) const;

  MemoryLimit& memory_;
  std::vector<uint32_t> ring_;  ///< vertices, the lowest first
  std::vector<double3> space_;  ///< corners from the first one on, in parts of the size
  std::vector<Flat> flat_;      ///< the same in the plane
  std::vector<uint32_t> before_, after_, order_, cell_start_, cell_corner_;
  std::vector<Ear> ears_;  ///< a heap
  size_t left_ = 0;        ///< corners
  size_t cells_ = 1;       ///< of a side of the grid
  double rounding_ = 0;    ///< of the coordinates, in parts of the size
  bool planar_ = false;
  uint64_t work_ = 0, most_work_ = 0;
};

}  // namespace weft::io
