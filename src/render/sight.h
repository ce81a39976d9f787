// Whether a camera that a scene places sees anything.
#pragma once

#include "render/framing.h"

#include <string>
#include <vector>

namespace weft::render {

/// Gathers moments of a run. Looks only at cameras with an eye of their own: the others are placed
/// so that they see all.
class Sight {
 public:
  Sight(const io::Scene&, const Framing&);

  void add(const io::Surface&);

  /// A line each, with path, reason and remedy; empty when there is something to look at.
  std::vector<std::string> problems() const;

 private:
  const io::Scene& scene_;
  Axes axes_;
  double half_width_, half_height_;
  bool seen_ = false;
  double pixels_ = 0;  ///< the longest side of what was in view, at its largest
};

}  // namespace weft::render
