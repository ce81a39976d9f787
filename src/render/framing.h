// What a camera has in its picture, and from where it has.
#pragma once

#include "render/solids.h"

#include "io/scene.h"
#include "io/surface.h"

#include <array>
#include <vector>

namespace weft::render {

/// Right, up and back: an orthonormal frame; `back` points at the viewer.
struct Axes {
  Vector3d right, up, back;
};
Axes axes_of(const Vector3d& back, const Vector3d& up);

/// Gathers points that are to be seen. The direction of view is the scene's or, without one, from a
/// little above and to the side of what the cloths face at the start.
class Framing {
 public:
  Framing(const io::Scene&, const io::Surface& start);

  void add(const Vector3d& point);
  void add(const Box&);

  const Axes& axes() const { return axes_; }
  const Box& box() const { return box_; }
  /// The nearest place, looking along the axes, from which all is in the picture with a margin, and
  /// not so near that what is in front looks much larger than what is behind.
  Vector3d eye() const;
  double half_height() const { return half_height_; }  ///< tangent of half the angle of view
  double half_width() const { return half_width_; }

 private:
  Axes axes_;
  double half_height_, half_width_;
  Box box_;
  std::array<Vector3d, 4> sides_;  ///< normals of the four sides of the pyramid of view
  std::array<double, 4> reach_;    ///< how far what was added lies along each
  double front_ = -1e300;          ///< and along `back`
};

/// Where cloths are at the start and, roughly, will be. Pinned ones swing around their pins and
/// hang down or fly from them; others go as they are thrown, as far as a collider or some of their
/// sizes.
void add_cloths(const io::Scene&, const io::Surface& start, const std::vector<Solid>&, Framing&);

/// Colliders near what was added, at any time of the run.
void add_colliders(const std::vector<Solid>&, double duration, Framing&);

}  // namespace weft::render
