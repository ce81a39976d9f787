// Whether a camera stands where it sees well; the painter knows whether it saw anything.
#pragma once

#include "render/framing.h"

#include <string>
#include <vector>

namespace weft::render {

/// Gathers moments of a run. Cameras without an eye of their own are placed so that they see all.
class Sight {
 public:
  Sight(const io::Scene&, const Framing&);

  void add(const io::Surface&);

  /// A line each, with path, reason and remedy; empty when there is something to look at. `framing`
  /// has seen the same moments.
  std::vector<std::string> problems(const Framing& framing) const;

 private:
  std::vector<std::string> problems_of_eye(const Framing&) const;

  const io::Scene& scene_;
  Axes axes_;
  double half_width_, half_height_;
  bool seen_ = false;
  double pixels_ = 0;   ///< the longest side of what was in view, at its largest
  double largest_ = 0;  ///< m: radius of a ball around all cloths, at its largest
};

}  // namespace weft::render
