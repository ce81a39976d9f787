// Arithmetic on points of the public interface, and the rotation of a pose.
#pragma once

#include <cmath>

#include "weft/world.hpp"

namespace weft::api {

inline double3 minus(const double3& a, const double3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline double3 plus(const double3& a, const double3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline double3 times(double s, const double3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double inner(const double3& a, const double3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double3 outer(const double3& a, const double3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline bool same(const double3& a, const double3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
inline double length(const double3& a) { return std::sqrt(inner(a, a)); }

/// Rows of the matrix that rotates by `degrees` about `axis`; exact for quarter turns about an axis
/// of coordinates. `of` names the
/// description in messages. Throws InvalidInput for a zero axis, unless nothing is turned.
void rotation_rows(const double3& axis, double degrees, const char* of, double3* rows);
/// Throws InvalidInput when a component is not finite.
double3 checked_vector(const double3&, const char* field);

/// Rounded to float as the device rounds.
double3 rounded_to_float(const double3& v);

}  // namespace weft::api
