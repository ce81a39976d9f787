// Triangles that a mesh names more than once.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/host_memory.h"

namespace weft::scene {

/// The triangles of a mesh, each once.
struct Faces {
  Vector<uint32_t> kept;  ///< numbers of the triangles, ascending
  /// By kept triangle: given both ways round, so that it may be turned; empty when none is.
  Vector<bool> both_ways;
  Vector<bool> turned;  ///< by kept triangle: the other way round than given first; or empty
  uint32_t repeats = 0;
  uint32_t first_repeat = 0, its_like = 0;  ///< the first triangle that is given again, and as what

  bool is_turned(size_t k) const { return !turned.empty() && turned[k]; }
};

/// `corners` holds 3 vertices per triangle. Triangles that have lost a corner are kept. Where a
/// triangle is given both ways round, it runs as its neighbours that are given one way only, across
/// the edges of two triangles; without such, as the first of its piece.
Faces distinct_faces(const Vector<uint32_t>& corners);

}  // namespace weft::scene
