// The response of one particle to one collider: out along the normal, with Coulomb friction.
#pragma once

#include "kernels/placement.h"
#include "kernels/sweep.h"
#include "state/particles.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Whether a particle has to do with a collider that does not turn: it is inside, or fast.
template <class Shape, class T>
struct Concern {
  Vec3Array<T> x_in, x_out;
  Shape shape;
  Vec3<T> by_before, by_now;

  WEFT_HD bool operator()(int i) const {
    const Vec3<T> p1 = load(x_out, i) - by_now;
    const bool inside = is_inside(shape, p1);
    if constexpr (!IsSwept<Shape>::value) {
      return inside;
    } else {
      const bool fast = magnitude2(p1 - (load(x_in, i) - by_before)) > shape.surface.sweep2;
      return inside | fast;
    }
  }
};

/// `Position`: the displacement is kept as the previous position.
template <class T, bool Position, class Shape, class Placement>
struct Contact {
  const T* inverse_mass;
  ParticleBuffers<T> p;
  Shape shape;
  Placement before, now;

  WEFT_HD Vec3<T> way(int i) const {
    return at_start(now, load(p.x_out, i)) - at_start(before, load(p.x_in, i));
  }
  WEFT_HD bool is_fast(int i) const { return magnitude2(way(i)) > shape.surface.sweep2; }

  /// A fast particle whose way leads through the shape, or so deep into it that the way out would
  /// be on the far side, ends the substep where it entered and keeps the velocity along the
  /// surface. For single particles: it branches.
  WEFT_HD void stop_at_entry(int i) const {
    if (!(inverse_mass[i] > T(0))) return;
    const Vec3<T> x = load(p.x_out, i);
    const Vec3<T> p0 = at_start(before, load(p.x_in, i)), p1 = at_start(now, x), way = p1 - p0;
    const T length2 = magnitude2(way);
    if (!(length2 > shape.surface.sweep2)) return;
    if (is_inside(shape, p1) && !(dot(way_out(shape, p1).normal, way) > T(0))) return;
    const Entry<T> at = entry(shape, p0, p1);
    // What only grazes the surface slides on it.
    if (at.time > T(1) || !(at.within * at.within * length2 > shape.surface.sweep2)) return;

    const Vec3<T> entered = at_present(now, p0 + at.time * way);
    const Vec3<T> normal = turned(now, at.normal);
    const Vec3<T> d = displacement_of(i, x), slip = d - carried(before, now, entered);
    const T against = larger(T(0), -dot(slip, normal));
    const Vec3<T> along = slip + against * normal;
    const Vec3<T> drag = friction_against(along, shape.surface.friction * against);
    store(p.x_out, i, entered);
    if constexpr (!Position) store(p.d_out, i, d + (against * normal + drag));
  }

  /// A particle inside goes to the surface. The displacement takes the same correction as the
  /// position, not the difference of positions: that would round away what the summed form keeps.
  /// In the position form it follows from the positions.
  WEFT_HD void push_out(int i) const {
    const Vec3<T> x = load(p.x_out, i), p1 = at_start(now, x);
    const bool free = inverse_mass[i] > T(0), inside = is_inside(shape, p1);
    const WayOut<T> out = way_out(shape, p1);
    const T depth = free & inside ? out.depth : T(0);
    const Vec3<T> normal = turned(now, out.normal);
    const Vec3<T> d = displacement_of(i, x), slip = d - carried(before, now, x);
    const T across = dot(slip, normal);
    const T moved = impact_share(depth, across, square_root(dot(slip, slip))) * depth;
    const Vec3<T> drag = friction_against(slip - across * normal, shape.surface.friction * moved);
    const bool hit = depth > T(0);
    const Vec3<T> none{T(0), T(0), T(0)};
    store(p.x_out, i, x + select(hit, depth * normal + drag, none));
    if constexpr (!Position) store(p.d_out, i, d + select(hit, moved * normal + drag, none));
  }

 private:
  WEFT_HD Vec3<T> displacement_of(int i, Vec3<T> x) const {
    if constexpr (Position) {
      return x - load(p.x_in, i);
    } else {
      return load(p.d_out, i);
    }
  }
};

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
