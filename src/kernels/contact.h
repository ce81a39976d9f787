// The response of one particle to one collider: out along the normal, with Coulomb friction.
#pragma once

#include "kernels/placement.h"
#include "kernels/sweep.h"
#include "state/particles.h"

namespace weft {
namespace WEFT_BACKEND_NS {

/// Whether a particle has to do with a collider: it is inside, or fast; in the position form also
/// when it was inside a substep ago.
template <class T, bool Position, class Shape, class Placement>
struct Concern {
  ParticleBuffers<T> p;
  Shape shape;
  Placement before, now;

  WEFT_HD bool operator()(int i) const {
    const Vec3<T> p1 = at_start(now, load(p.x_out, i));
    bool inside = is_inside(shape, p1);
    if constexpr (Position) {
      const Vec3<T> previous = load(p.d_in, i) + carried(before, now, load(p.x_in, i));
      inside |= is_inside(shape, at_start(before, previous));
    }
    if constexpr (!IsSwept<Shape>::value) {
      return inside;
    } else {
      const bool fast = magnitude2(p1 - at_start(before, load(p.x_in, i))) >
                        shape.surface.sweep * shape.surface.sweep;
      return inside | fast;
    }
  }
};

/// How far along -normal other particles have pushed one since it went its displacement d, but for
/// rounding. `pushed`: 1 where any may have, else 0.
template <class T>
WEFT_HD T pushed_into(T pushed, Vec3<T> x0, Vec3<T> x, Vec3<T> d, Vec3<T> normal) {
  return pushed * larger(T(0), -dot((x - x0) - d, normal) - rounding_of(x));
}

/// `Position`: the displacement is kept as the previous position.
template <class T, bool Position, class Shape, class Placement>
struct Contact {
  const T* inverse_mass;
  ParticleBuffers<T> p;
  Shape shape;
  Placement before, now;
  T ratio;   ///< of this substep's length and the last one's
  T pushed;  ///< 1: other particles may have pushed these (pushed_into)

  WEFT_HD Vec3<T> way(int i) const {
    return at_start(now, load(p.x_out, i)) - at_start(before, load(p.x_in, i));
  }
  WEFT_HD bool is_fast(int i) const {
    return magnitude2(way(i)) > shape.surface.sweep * shape.surface.sweep;
  }

  /// A fast particle that comes from outside ends the substep where it enters; one that was at the
  /// surface already slides along it. Either loses its velocity into the surface. For single
  /// particles: it branches.
  WEFT_HD void stop_at_entry(int i) const {
    if (!(inverse_mass[i] > T(0))) return;
    const Vec3<T> x = load(p.x_out, i), x0 = load(p.x_in, i);
    const Vec3<T> p0 = at_start(before, x0), p1 = at_start(now, x), way = p1 - p0;
    const T length2 = magnitude2(way);
    if (!(length2 > shape.surface.sweep * shape.surface.sweep)) return;
    const Entry<T> at = first_entry(p0, p1);
    const T into = dot(way, at.normal);
    if (at.time > T(1) || !(into < T(0))) return;
    // What only grazes the shape and ends outside goes its way.
    const bool grazes = at.within * at.within * length2 < shape.surface.sweep * shape.surface.sweep;
    if (grazes && !is_inside(shape, p1)) return;

    const bool slides = at.time * square_root(length2) <= surface_of(p0);
    const Vec3<T> to = slides ? p0 + (way - into * at.normal) : p0 + at.time * way;
    const Vec3<T> normal = turned(now, at.normal);
    const Vec3<T> d = displacement_of(i, x), slip = d - carried(before, now, x0);
    const T across = dot(slip, normal), against = larger(T(0), -across);
    const Vec3<T> sliding = slip - across * normal;
    const Vec3<T> drag = (-part_held(sliding, shape.surface.friction * against)) * sliding;
    const Vec3<T> at_end = at_present(now, to);
    store(p.x_out, i, slides ? at_end + drag : at_end);
    if constexpr (!Position) store(p.d_out, i, d + (against * normal + drag));
  }

  /// A particle inside goes to the surface along the normal where the substep began, as SHAKE puts
  /// a constraint's force (Ryckaert, Ciccotti and Berendsen 1977): without friction a way along a
  /// curved surface keeps its speed, and out of a convex shape nothing gains any while the normals
  /// of both ends are within 60 degrees (docs/collisions.md). Where they are not, as past the edge
  /// of a box, and from deep inside it goes along the normal where it ended, and its velocity takes
  /// only what it came in with (hard case 46).
  ///
  /// The displacement takes the same correction as the position, not the difference of positions:
  /// that would round away what the summed form keeps. Nor does it take back what other particles
  /// have pushed in: that was none of its own. In the position form it follows from the positions.
  WEFT_HD void push_out(int i) const {
    const Vec3<T> x0 = load(p.x_in, i), along = carried(before, now, x0);
    const WayOut<T> start = way_out(shape, at_start(before, x0));
    const Vec3<T> x = load(p.x_out, i), p1 = at_start(now, x);
    const bool free = inverse_mass[i] > T(0), inside = is_inside(shape, p1);
    const WayOut<T> out = way_out(shape, p1);
    const bool meets = free & inside;
    const T depth = meets ? out.depth : T(0);
    const T before_depth = larger(T(0), start.depth);
    const bool deep = before_depth > surface_of(p1);
    // 1 - |n1 - n0|^2/2 is their product, and 1 to the last bit where the surface is flat.
    // Where the substep began, in the world: a body that spins must not take the normal along. A
    // flat face turns with its body.
    const bool one_face = !(magnitude2(out.normal - start.normal) > T(0));
    const Vec3<T> out_now = turned(now, out.normal);
    const Vec3<T> start_now = select(one_face, out_now, turned(before, start.normal));
    const Vec3<T> bend = out_now - start_now;
    const T cosine = T(1) - T(0.5) * magnitude2(bend);
    const bool held_back = deep | (cosine < T(0.5));
    const Vec3<T> normal = select(held_back, out_now, start_now);
    const T per_depth = T(1) / (held_back ? T(1) : cosine);
    const Vec3<T> d = displacement_of(i, x), slip = d - along;
    const T across = dot(slip, normal);
    const T by_others = Position ? T(0) : pushed_into(pushed, x0, x, d, normal);
    const T made = per_depth * larger(T(0), depth - before_depth - by_others);  // in this substep
    const T moved = held_back ? stopped_displacement(depth, across) : made;
    const T most = shape.surface.friction * moved;
    const Vec3<T> sliding = slip - across * normal;
    const T held = part_held(sliding, most);
    const Vec3<T> drag = (-held) * sliding;
    // A slide that is taken back leads below a surface that is curved.
    const T bent = held_back ? T(0) : dot(sliding, bend);
    const T again = (held - T(0.5) * held * held) * bent;
    // What lay on the surface and sticks there is where it was, to the last bit.
    const bool flat = !(magnitude2(bend) > T(0));
    const T rounding = rounding_of(p1) + magnitude(bent);
    const T above = flat ? -across - depth : -start.depth;
    const bool lay = (before_depth <= rounding) & (above <= rounding);
    const bool holds = (magnitude2(sliding) <= most * most) & (most > T(0));
    const bool hit = depth > T(0), sticks = meets & lay & holds;
    const Vec3<T> none{T(0), T(0), T(0)};
    const Vec3<T> pushed = x + select(hit, (per_depth * depth + again) * normal + drag, none);
    store(p.x_out, i, select(sticks, x0 + along, pushed));
    if constexpr (!Position) {
      const Vec3<T> braked = d + select(hit, (moved + again) * normal + drag, none);
      store(p.d_out, i, select(sticks, along, braked));
    }
  }

  /// In the position form the way out of deep inside is the displacement that the next substep
  /// begins with: it is taken back. The collider is taken to have moved as it does now.
  WEFT_HD void take_back_throw(int i) const {
    const Vec3<T> x0 = load(p.x_in, i), along = carried(before, now, x0), x = load(p.x_out, i);
    const Vec3<T> previous = load(p.d_in, i) + along, p_previous = at_start(before, previous);
    const WayOut<T> start = way_out(shape, at_start(before, x0));
    const T surface = surface_of(p_previous);
    const Vec3<T> normal = turned(before, start.normal);
    const T thrown = larger(T(0), dot(x0 - previous, normal));
    const bool was_deep = (way_out(shape, p_previous).depth > surface) & (start.depth <= surface);
    const bool takes = was_deep & (inverse_mass[i] > T(0));
    store(p.x_out, i, x - select(takes, (ratio * thrown) * normal, Vec3<T>{T(0), T(0), T(0)}));
  }

 private:
  /// How near to the surface a particle counts as being at it: rounding, or a trifle of the size.
  WEFT_HD T surface_of(Vec3<T> p0) const { return T(1e-3) * shape.surface.sweep + rounding_of(p0); }
  /// Where the way enters. A beginning a hair's breadth inside counts as at the surface; from
  /// deeper inside nothing is entered.
  WEFT_HD Entry<T> first_entry(Vec3<T> p0, Vec3<T> p1) const {
    if (!is_inside(shape, p0)) return entry(shape, p0, p1);
    const WayOut<T> out = way_out(shape, p0);
    const bool at_surface = out.depth <= surface_of(p0);
    return {at_surface ? T(0) : T(2), T(1), out.normal};
  }
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
