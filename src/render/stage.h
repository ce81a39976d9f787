// Where the camera, the light and the ground of a picture are.
#pragma once

#include "render/framing.h"

#include <Eigen/Core>

namespace weft::render {

/// Points of a picture are in metres relative to `origin`, so that a scene far from zero loses no
/// digits; matrices go from there to clip coordinates.
struct Stage {
  Vector3d origin;
  float radius;        ///< of a ball around `origin` that holds all that is expected to be seen
  Vector3f eye;        ///< of the camera
  Vector3f light, up;  ///< unit; towards the light
  Eigen::Matrix4f camera, shadow;
  Vector3f ground, ground_normal;  ///< a point of it at the start, and where its upper side faces
  Vector3f ground_velocity{0, 0, 0};  ///< along the normal
  bool floor = true;                  ///< the ground is none of the scene: nothing goes below it
};

/// The ground is the scene's plane that faces up, or a floor below what is expected to be seen.
Stage make_stage(const io::Scene&, const io::Surface& start, const std::vector<Solid>&);

}  // namespace weft::render
