// What a camera has to have in its picture, and from where it has.
#pragma once

#include "render/box.h"

#include "io/scene.h"
#include "io/surface.h"

#include <array>
#include <optional>
#include <vector>

namespace weft::render {

/// Right, up and back: an orthonormal frame; `back` points at the viewer.
struct Axes {
  Vector3d right, up, back;
};
Axes axes_of(const Vector3d& back, const Vector3d& up);

/// Against gravity; without any, along y.
Vector3d up_of(const io::Scene&);

/// Gathers what is to be seen. The direction of view is the scene's or, without one, from a little
/// above and to the side of what the cloths face at the start.
class Framing {
 public:
  Framing(const io::Scene&, const io::Surface& start);

  /// A surface of some moment, its colliders left out.
  void add(const io::Surface&);
  void add(const Vector3d& point) { add(point, 0); }
  /// A ball.
  void add(const Vector3d& center, double radius);

  const Axes& axes() const { return axes_; }
  const Box& box() const { return box_; }
  /// How near to the scene's eye something in view comes, m; 1e300 when there is none.
  double nearest() const { return nearest_; }
  /// What a box holds may come that near to the eye.
  void expect(const Box&);
  /// The nearest place, looking along the axes, from which all is in the picture with a margin, and
  /// not so near that what is in front looks much larger than what is behind.
  Vector3d eye() const;
  double half_height() const { return half_height_; }  ///< tangent of half the angle of view
  double half_width() const { return half_width_; }

 private:
  Axes axes_;
  std::vector<bool> loose_;  ///< by vertex of a surface: it is not drawn
  double half_height_, half_width_;
  Box box_;
  std::optional<Vector3d> eye_;  ///< of the scene
  double nearest_ = 1e300;
  std::array<Vector3d, 4> sides_;  ///< normals of the four sides of the pyramid of view
  std::array<double, 4> reach_;    ///< how far what was added lies along each
  double front_ = -1e300;          ///< and along `back`
};

/// With all colliders near what was added, at any time of the run.
void add_colliders(const io::Scene&, Framing&);

}  // namespace weft::render
