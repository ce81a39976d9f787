// Where the camera, the light and the ground of a picture are.
#pragma once

#include "render/framing.h"

#include <Eigen/Core>

namespace weft::render {

/// Points of a picture are in metres relative to `origin`, so that a scene far from zero loses no
/// digits; matrices go from there to clip coordinates.
struct Stage {
  Vector3d origin;
  Box seen;        ///< all that moves, and the colliders near it
  float radius;    ///< of a ball around `origin` that holds it
  Vector3f eye;    ///< of the camera
  Vector3f light;  ///< unit, towards it
  Eigen::Matrix4f camera, shadow;
  Vector3f ground, ground_normal;  ///< a point of it at the start, and where its upper side faces
  Vector3f ground_velocity{0, 0, 0};  ///< along the normal
};

/// m in front of the eye: what is nearer is not drawn. `radius` is that of all that is seen.
inline double nearest_drawn(double radius) { return 3e-4 * radius; }

/// The ground is the scene's plane that faces up, or a floor below all.
Stage make_stage(const io::Scene&, Framing);

}  // namespace weft::render
