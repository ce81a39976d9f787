// Scalars of one substep: the only thing that changes between two substeps of a frame.
#pragma once

#include "base/vec3.h"

namespace weft {

/// What the integration stage computes.
enum class Update : int32_t {
  summed,        ///< d += a dt^2, x += d
  position,      ///< x' = 2x - x_prev + a dt^2
  start,         ///< d of the taylor start from d = v0 dt; no position changes
  acceleration,  ///< writes the acceleration; no position changes
};
/// How drag enters the integration stage of a cloth.
enum class Drag : int32_t { none, central, lagged };

/// Air that moves, in the terms of a triangle's N = 2 A n (kernels/wind.h).
template <class T>
struct Wind {
  Vec3<T> velocity;
  T normal, tangential;  ///< air density * drag coefficient / 12
};

template <class T>
struct StepParams {
  Update update;
  bool position_form;  ///< `d` holds previous positions
  T dt;
  T ratio;         ///< dt of this substep / dt of the one before
  T a_factor;      ///< what the acceleration is multiplied by: dt (dt + dt_before)/2
  T square;        ///< dt^2
  bool newcomers;  ///< cloths that are starting have not moved: their substep before was dt too
  T time;          ///< from the start of the frame to the end of this substep
  T time_before;   ///< to its start
  T fraction;      ///< of the frame that is over at the end of this substep
  int substep;     ///< index in the frame
  Vec3<T> gravity;
  Wind<T> wind;
};

}  // namespace weft
