// How much longer the springs of the cloths are than at rest, measured against their cloth.
#pragma once

#include "io/build.h"

#include <vector>

namespace weft::tools {

/// Edges of triangles, springs of networks, neighbours in a row. A spring that is short beside the
/// others of its cloth, as between two vertices of a seam, may be many times as long as at rest and
/// nobody sees it: its lengthening counts in parts of their mean.
class Lengthening {
 public:
  /// At the start: where no rest length is given, it is the distance now.
  Lengthening(const io::Scene&, io::RunningScene&);

  /// The most (l - l0)/max(l0, mean l0) of a spring now; 0 where none is longer.
  double most(io::RunningScene&) const;

 private:
  std::vector<double3> read(io::RunningScene&, size_t cloth) const;
  template <class Take>
  void each_spring(const io::RunningScene&, size_t cloth, Take) const;

  const io::Scene& scene_;
  std::vector<std::vector<double3>> start_;  ///< by cloth, of its particles
};

}  // namespace weft::tools
