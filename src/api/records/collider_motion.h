// Rigid motion of colliders: placements, and the rotation in between two of them.
#pragma once

#include "api/context/vector_math.h"

namespace weft::api {

struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;
};

/// world = rows * (a point of the shape, from its middle) + translate
struct Placed {
  double3 rows[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  double3 translate{0, 0, 0};
  Quaternion rotation;   ///< the same as `rows`
  bool endless = false;  ///< a plane's: it has no middle, so it goes on a screw
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
/// The rotation of a place turned further, which stays one however often it is done.
Placed turned_further(const Placed& turn, const Placed& from);

/// As far beyond `to` as that is from `from`.
Placed continued(const Placed& from, const Placed& to);

double3 rotate(const double3* rows, const double3& v);
double3 to_world(const Placed&, const double3& described);
bool same_rotation(const Placed&, const Placed&);
bool same_place(const Placed&, const Placed&);

/// Where a collider is at a fraction of its way, 0 to 1; both ends to the bit. The middle goes
/// straight, the rotation the shorter way about one axis, both uniformly. What is endless has a
/// screw motion, which no choice of a middle changes.
Placed between(const Placed& from, const Placed& to, double fraction);
/// How far the rotation goes: the cosine of half its angle, 0 (half a turn) to 1.
double half_turn_cosine(const Placed& begin, const Placed& end);

/// The rotation since `begin` after each of some equal parts of the way to `end`.
class TurnInParts {
 public:
  TurnInParts(const Placed& begin, const Placed& end, int parts);
  /// The nine numbers of the next, row by row: the first call is for the end of the first part.
  template <class T>
  void next(T* numbers) {
    advance();
    for (int i = 0; i < 9; ++i) {
      numbers[i] = static_cast<T>(along_[i] + (cos_ * across_[i] + sin_ * beside_[i]));
    }
  }

 private:
  void advance() {
    if (--left_ == 0) {  // to the very place
      for (int i = 0; i < 9; ++i) along_[i] = last_[i];
      cos_ = sin_ = 0;
      return;
    }
    const double c = cos_ * part_cos_ - sin_ * part_sin_, s = cos_ * part_sin_ + sin_ * part_cos_;
    const double unit = 1.5 - 0.5 * (c * c + s * s);  // one step of Newton's towards |(c, s)| = 1
    cos_ = unit * c;
    sin_ = unit * s;
  }

  // along + cos across + sin beside, by Rodrigues' formula
  double along_[9], across_[9], beside_[9], last_[9];
  double part_cos_, part_sin_, cos_ = 1, sin_ = 0;
  int left_;
};

}  // namespace weft::api
