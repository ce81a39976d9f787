// Rigid motion of colliders: placements, and the rotation in between two of them.
#pragma once

#include "api/context/vector_math.h"

namespace weft::api {

struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;
};

/// world = rows * described + translate
struct Placed {
  double3 rows[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  double3 translate{0, 0, 0};
  Quaternion rotation;  ///< the same as `rows`
};
/// Throws InvalidInput; `of` names the pose in messages.
Placed placed_by(const Pose&, const char* of);

/// The shortest turn of the unit vector `from` to the unit vector `to`; half a turn goes about
/// `side`, a unit vector across `from`.
Placed turn_from_to(const double3& from, const double3& to, const double3& side);
/// The turn of three unit vectors, across each other, to three others of the same handedness.
Placed turn_of_edges(const double3* from, const double3* to);

/// First `first`, then `then`.
Placed after(const Placed& then, const Placed& first);

/// As far beyond `to` as that is from `from`.
Placed continued(const Placed& from, const Placed& to);

double3 rotate(const double3* rows, const double3& v);
double3 to_world(const Placed&, const double3& described);
bool same_rotation(const Placed&, const Placed&);
bool same_place(const Placed&, const Placed&);

/// Rows of the rotation that has taken place since `begin` at a fraction of the way to `end`: by
/// the shorter way about one axis, nearly uniform (the chord between the quaternions, normalised).
void turn_between(const Placed& begin, const Placed& end, double fraction, double3* rows);

}  // namespace weft::api
