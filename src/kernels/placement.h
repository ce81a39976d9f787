// Where a collider is during a frame, relative to where it was at its start.
#pragma once

#include "state/colliders.h"
#include "state/step.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// A collider that does not turn.
template <class T>
struct Shifted {
  Vec3<T> by;
};
/// One that turns about its pivot.
template <class T>
struct Turned {
  Mat3<T> turn;
  Vec3<T> pivot, by;
};

/// The point of the collider, as it was at the start of the frame, that is now at x.
template <class T>
WEFT_HD Vec3<T> at_start(const Shifted<T>& p, Vec3<T> x) {
  return x - p.by;
}
template <class T>
WEFT_HD Vec3<T> at_start(const Turned<T>& p, Vec3<T> x) {
  return back(p.turn, x - (p.pivot + p.by)) + p.pivot;
}
/// The reverse.
template <class T>
WEFT_HD Vec3<T> at_present(const Shifted<T>& p, Vec3<T> x) {
  return x + p.by;
}
template <class T>
WEFT_HD Vec3<T> at_present(const Turned<T>& p, Vec3<T> x) {
  return p.turn * (x - p.pivot) + (p.pivot + p.by);
}
/// A direction of the start as it is now.
template <class T>
WEFT_HD Vec3<T> turned(const Shifted<T>&, Vec3<T> v) {
  return v;
}
template <class T>
WEFT_HD Vec3<T> turned(const Turned<T>& p, Vec3<T> v) {
  return p.turn * v;
}
/// How far the collider's point that was at x has come since `before`: what sticks there goes
/// along.
template <class T>
WEFT_HD Vec3<T> carried(const Shifted<T>& before, const Shifted<T>& now, Vec3<T>) {
  return now.by - before.by;
}
template <class T>
WEFT_HD Vec3<T> carried(const Turned<T>& before, const Turned<T>& now, Vec3<T> x) {
  return at_present(now, at_start(before, x)) - x;
}

/// At the end of a substep; `ago` = 1: at its start.
template <class T>
WEFT_HD Shifted<T> shifted(const Surface<T>& s, const StepParams<T>& step, int ago) {
  return {(ago == 0 ? step.time : step.time_before) * s.velocity};
}
template <class T>
WEFT_HD Turned<T> turned(const Colliders<T>& colliders, const Surface<T>& s,
                         const StepParams<T>& step, int ago) {
  const int row = step.substep + 1 - ago;
  return {colliders.turn[int64_t(row) * colliders.turns + s.turn], s.pivot,
          shifted(s, step, ago).by};
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
