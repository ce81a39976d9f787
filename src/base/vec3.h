// Vectors of three scalars. The type is plain data; its operators live in the back end's namespace.
#pragma once

#include "base/portability.h"

namespace weft {

template <class T>
struct Vec3 {
  T x, y, z;
};

/// Rows of a matrix.
template <class T>
struct Mat3 {
  Vec3<T> row[3];
};

namespace WEFT_BACKEND_NS {

template <class T>
WEFT_HD Vec3<T> operator+(Vec3<T> a, Vec3<T> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
WEFT_HD Vec3<T> operator-(Vec3<T> a, Vec3<T> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
WEFT_HD Vec3<T> operator*(T s, Vec3<T> a) {
  return {s * a.x, s * a.y, s * a.z};
}
/// Summed in the order x, y, z.
template <class T>
WEFT_HD T dot(Vec3<T> a, Vec3<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
WEFT_HD Vec3<T> cross(Vec3<T> a, Vec3<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
WEFT_HD Vec3<T> operator*(const Mat3<T>& m, Vec3<T> v) {
  return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)};
}
/// The transposed matrix times v: a rotation taken back.
template <class T>
WEFT_HD Vec3<T> back(const Mat3<T>& m, Vec3<T> v) {
  return (v.x * m.row[0] + v.y * m.row[1]) + v.z * m.row[2];
}
/// `yes` where the condition holds, else `no`; both are always evaluated.
template <class T>
WEFT_HD Vec3<T> select(bool condition, Vec3<T> yes, Vec3<T> no) {
  return {condition ? yes.x : no.x, condition ? yes.y : no.y, condition ? yes.z : no.z};
}
template <class T>
WEFT_HD T smaller(T a, T b) {
  return a < b ? a : b;
}
template <class T>
WEFT_HD T larger(T a, T b) {
  return a > b ? a : b;
}
WEFT_HD float square_root(float a) { return __builtin_sqrtf(a); }
WEFT_HD double square_root(double a) { return __builtin_sqrt(a); }

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
