// Vectors of three scalars. The type is plain data; its operators live in the back end's namespace.
#pragma once

#include "base/portability.h"

namespace weft {

template <class T>
struct Vec3 {
  T x, y, z;
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
/// `yes` where the condition holds, else `no`; both are always evaluated.
template <class T>
WEFT_HD Vec3<T> select(bool condition, Vec3<T> yes, Vec3<T> no) {
  return {condition ? yes.x : no.x, condition ? yes.y : no.y, condition ? yes.z : no.z};
}
WEFT_HD float square_root(float a) { return __builtin_sqrtf(a); }
WEFT_HD double square_root(double a) { return __builtin_sqrt(a); }

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
