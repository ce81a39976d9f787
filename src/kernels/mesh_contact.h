// Contact of a particle with a triangle mesh: one that comes nearer than the thickness goes to the
// thickness, away from the nearest point of the mesh. The nearest point is exact.
//
// A step longer than half the thickness is walked in pieces of at most that: the distance to the
// mesh changes by no more than the piece, so that the first piece that ends within the thickness
// has not reached the surface yet, and nothing tunnels.
#pragma once

#include "kernels/colliders.h"
#include "kernels/mesh_nearest.h"

namespace weft {
namespace WEFT_BACKEND_NS {

template <class T>
struct MeshContact {
  bool hit;
  Vec3<T> to;      ///< where the particle must go
  Vec3<T> normal;  ///< unit vector from the mesh to there
  bool stopped;    ///< it was caught on the way, and `to` is where it came in
  int32_t over;    ///< the triangle whose face is the nearest; -1: an edge, a corner or none
  bool slides;     ///< it lay on the surface, went far, and is pushed along the normal there
  bool plain;      ///< the push is along the normal, from outside and from no other side
};

template <class T>
WEFT_HD MeshContact<T> untouched(Vec3<T> x) {
  return {false, x, {T(0), T(0), T(0)}, false, -1, false, false};
}

/// The first triangle that a way goes through; `triangle` is -1 if there is none.
template <class T>
struct Crossing {
  int32_t triangle;
  T share;  ///< of the way until there
  T side;   ///< 1: it came from where the triangle's normal points to; else -1
};

/// Triangles reach a little beyond their edges here, so that nothing slips between two of them.
/// Closed meshes are crossed from outside only.
template <class T>
WEFT_HD void find_crossing(const TriangleGrid<T>& grid, int32_t triangle, Vec3<T> from, Vec3<T> to,
                           Crossing<T>& first) {
  T a[4], b[4];
  plane_values(grid.planes[triangle], from, a);
  plane_values(grid.planes[triangle], to, b);
  const bool above = a[0] >= T(0);
  if (above == (b[0] >= T(0)) || (grid.closed != 0 && !above)) return;
  const T share = a[0] / (a[0] - b[0]);
  const T rounding = magnitude(to.x) + magnitude(to.y) + magnitude(to.z);
  const T beyond = T(1e-3) * grid.thickness + T(3e-7) * rounding;
  for (int e = 1; e < 4; ++e) {
    if (a[e] + share * (b[e] - a[e]) > beyond) return;
  }
  if (first.triangle >= 0 && share > first.share) return;
  if (first.triangle >= 0 && share == first.share && triangle >= first.triangle) return;
  first = {triangle, share, above ? T(1) : T(-1)};
}

/// `from` and `to` are less than the thickness apart.
template <class T>
WEFT_HD_COLD Crossing<T> first_crossing(const TriangleGrid<T>& grid, Vec3<T> from, Vec3<T> to) {
  Crossing<T> first{-1, T(0), T(1)};
  const Cell a = clamped_cell(grid, from), b = clamped_cell(grid, to);
  const int x1 = a.i < b.i ? b.i : a.i, y1 = a.j < b.j ? b.j : a.j, z1 = a.k < b.k ? b.k : a.k;
  for (int k = a.k < b.k ? a.k : b.k; k <= z1; ++k) {
    for (int j = a.j < b.j ? a.j : b.j; j <= y1; ++j) {
      for (int i = a.i < b.i ? a.i : b.i; i <= x1; ++i) {
        const int32_t start = grid.cell_start[cell_number(grid, Cell{i, j, k})];
        if (start < 0) continue;
        for (const int32_t* entry = grid.entry_triangle + start;; ++entry) {
          find_crossing(grid, *entry < 0 ? ~*entry : *entry, from, to, first);
          if (*entry < 0) break;
        }
      }
    }
  }
  return first;
}

template <class T>
struct Touch {
  MeshContact<T> contact;
  bool crossed;  ///< went through a triangle
};

/// The way out for x, from the nearest point and as it lies.
template <class T>
WEFT_HD Vec3<T> outward(const TriangleGrid<T>& grid, const Nearest<T>& near, Vec3<T> from,
                        Vec3<T> x) {
  const Vec3<T> face = face_normal(grid, near.triangle);
  const bool on_face = near.feature < 0;
  const T distance = square_root(near.distance2);
  const bool at_surface = !(distance > T(1e-3) * grid.thickness);  // `away` is rounding
  if (grid.closed != 0) {
    const bool deep = near.inside && distance > grid.thickness;  // the point is roughly the nearest
    const Vec3<T> pseudonormal = on_face ? face : grid.sides[near.triangle].normal[near.feature];
    if (on_face || at_surface || deep) return pseudonormal;
    return ((near.inside ? T(-1) : T(1)) / distance) * near.away;
  }
  if (!on_face && !at_surface) return (T(1) / distance) * near.away;
  const T height = dot(face, near.away);
  const T before = height + dot(face, from - x);
  const bool above = at_surface ? before >= T(0) : height >= T(0);
  return above ? face : T(-1) * face;
}

/// Contact of a particle that came to x from less than the thickness away.
template <class T>
WEFT_HD_COLD Touch<T> touch(const TriangleGrid<T>& grid, const Nearest<T>& near, Vec3<T> from,
                            Vec3<T> x) {
  if (near.triangle < 0) return {untouched(x), false};
  Vec3<T> away = near.away, normal = outward(grid, near, from, x);
  const Vec3<T> way = x - from;
  bool crossed = false;
  if (near.distance2 <= dot(way, way)) {
    const Crossing<T> crossing = first_crossing(grid, from, x);
    crossed = crossing.triangle >= 0;
    if (crossed) {
      // Back to the side it came from. The nearest face may belong to another sheet: only one that
      // looks the same way is taken.
      const Vec3<T> back = crossing.side * face_normal(grid, crossing.triangle);
      const T alike = dot(back, face_normal(grid, near.triangle));
      const bool same_way = alike > T(0.5) || (grid.closed == 0 && alike < T(-0.5));
      const bool same_sheet = near.feature < 0 && same_way;
      const T height = dot(back, x - grid.corners[crossing.triangle].corner[0]);
      normal = same_sheet ? (alike > T(0) ? T(1) : T(-1)) * face_normal(grid, near.triangle) : back;
      away = same_sheet ? away : height * back;
    }
  }
  const bool at_surface = !(near.distance2 > T(1e-6) * grid.thickness * grid.thickness);
  const bool plain = !crossed && !near.inside && !at_surface;
  const int32_t over = near.feature < 0 ? near.triangle : -1;
  return {{true, x + (grid.thickness * normal - away), normal, false, over, false, plain}, crossed};
}

/// The part of the way that lies in the grid, as shares of it.
template <class T>
struct Span {
  T in, out;
};
template <class T>
WEFT_HD Span<T> clip(Span<T> span, T from, T way, T low, T high) {
  if (!(way > T(0) || way < T(0))) {
    return from >= low && from <= high ? span : Span<T>{T(1), T(0)};
  }
  const T a = (low - from) / way, b = (high - from) / way;
  const T in = a < b ? a : b, out = a < b ? b : a;
  return {in > span.in ? in : span.in, out < span.out ? out : span.out};
}

/// The first touch on a long way. One that starts within the thickness may leave it, and is caught
/// if it comes back or goes through a triangle.
template <class T>
WEFT_HD_COLD MeshContact<T> sweep(const TriangleGrid<T>& grid, Vec3<T> p0, Vec3<T> p1) {
  const Vec3<T> way = p1 - p0, low = grid.low;
  const T size = grid.cell_size;
  Span<T> span{T(0), T(1)};
  span = clip(span, p0.x, way.x, low.x, low.x + T(grid.cells[0]) * size);
  span = clip(span, p0.y, way.y, low.y, low.y + T(grid.cells[1]) * size);
  span = clip(span, p0.z, way.z, low.z, low.z + T(grid.cells[2]) * size);
  if (!(span.in <= span.out)) return untouched(p1);

  constexpr int most_pieces = most_sweep_pieces;
  const T part = span.out - span.in;
  const T wanted = square_root(dot(way, way)) * part / (T(0.5) * grid.thickness);
  const int pieces = wanted < T(most_pieces) ? 1 + int(wanted) : most_pieces;
  Vec3<T> from = p0 + span.in * way;
  bool outside = false;
  for (int piece = 0; piece <= pieces; ++piece) {
    const bool at_end = piece == pieces && span.out >= T(1);
    const T share = span.in + part * (T(piece) / T(pieces));
    const Vec3<T> x = at_end ? p1 : p0 + share * way;
    Touch<T> found = touch(grid, nearest(grid, x), from, x);
    if (found.contact.hit && (outside || found.crossed || at_end)) {
      found.contact.stopped = !at_end;
      return found.contact;
    }
    outside = outside || !found.contact.hit;
    from = x;
  }
  return untouched(p1);
}

template <class T>
WEFT_HD bool is_long(const TriangleGrid<T>& grid, Vec3<T> way) {
  const T short_way = T(0.5) * grid.thickness;
  return dot(way, way) > short_way * short_way;
}

/// In the position form what was stopped on its way must go on along the surface there, unless it
/// meets another: the way that is lost would be speed. Only the way into the surface is taken.
template <class T>
WEFT_HD MeshContact<T> slide_on(const TriangleGrid<T>& grid, Vec3<T> p1,
                                const MeshContact<T>& entry) {
  if (!entry.hit || !entry.stopped) return entry;
  const Vec3<T> left = p1 - entry.to;
  const T into = dot(left, entry.normal);
  if (!(into < T(0))) return entry;
  const Vec3<T> end = p1 - into * entry.normal;
  const Vec3<T> lift = (T(0.02) * grid.thickness) * entry.normal;
  const MeshContact<T> other = sweep(grid, entry.to + lift, end + lift);
  if (other.hit) return entry;
  return {true, end, entry.normal, false, -1, true, false};
}

/// A long way that begins on the surface, and into it, slides: along the tangent there, and back to
/// the surface along the normal there. What it meets on the tangent stops it.
template <class T>
WEFT_HD_COLD MeshContact<T> far(const TriangleGrid<T>& grid, Vec3<T> p0, Vec3<T> p1,
                                const NearMemory<T>& memory, int32_t mesh, bool goes_on) {
  const Nearest<T> start = nearest_about(grid, p0, memory, mesh);
  const T distance = square_root(start.distance2), above = distance - grid.thickness;
  const T trifle = T(0.01) * grid.thickness;
  if (start.triangle < 0 || start.inside || magnitude(above) > trifle) {
    const MeshContact<T> entry = sweep(grid, p0, p1);
    return goes_on ? slide_on(grid, p1, entry) : entry;
  }
  const Vec3<T> normal = (T(1) / distance) * start.away;
  const T into = dot(p1 - p0, normal);
  if (!(into < T(0))) return sweep(grid, p0, p1);
  const Vec3<T> end = p1 - into * normal, lift = (T(2) * trifle - above) * normal;
  const MeshContact<T> other = sweep(grid, p0 + lift, end + lift);
  if (other.hit) return other;
  const Nearest<T> near = nearest_about(grid, end, memory, mesh);
  const T left = square_root(near.distance2), gap = left - grid.thickness;
  const T cosine = dot(normal, near.away) / (left > T(0) ? left : T(1));
  const bool lands = near.triangle >= 0 && !near.inside && cosine > T(0.5);
  const T back = lands ? smaller(gap / cosine, -into) : T(0);
  return {true, end - back * normal, normal, false, -1, true, false};
}

/// Contact of a particle that moves from p0 to p1, both in the mesh's own frame.
template <class T>
WEFT_HD MeshContact<T> mesh_contact(const TriangleGrid<T>& grid, Vec3<T> p0, Vec3<T> p1) {
  if (is_long(grid, p1 - p0)) return far(grid, p0, p1, NearMemory<T>{}, 1, false);
  return touch(grid, nearest(grid, p1), p0, p1).contact;
}
/// The same with the memory of the particle; `mesh` names the collider in it.
template <class T>
WEFT_HD MeshContact<T> mesh_contact(const TriangleGrid<T>& grid, Vec3<T> p0, Vec3<T> p1,
                                    NearMemory<T>& memory, int32_t mesh, bool goes_on = false) {
  if (is_long(grid, p1 - p0)) return far(grid, p0, p1, memory, mesh, goes_on);
  const Nearest<T> near = nearest(grid, p1, memory, mesh);
  if (near.triangle < 0) return untouched(p1);
  return touch(grid, near, p0, p1).contact;
}

/// How much of the way before p0 led out of deep inside: the position form would go on with it.
template <class T>
WEFT_HD_COLD Vec3<T> thrown(const TriangleGrid<T>& grid, Vec3<T> p0, Vec3<T> way_before,
                            const NearMemory<T>& memory, int32_t mesh) {
  const Vec3<T> none{T(0), T(0), T(0)};
  const Nearest<T> was = nearest(grid, p0 - way_before);
  const T within = T(0.95) * grid.thickness;
  const bool was_deep = was.triangle >= 0 && (was.inside || was.distance2 < within * within);
  if (!was_deep) return none;
  const Nearest<T> near = nearest_about(grid, p0, memory, mesh);
  const T distance = square_root(near.distance2);
  if (near.triangle < 0 || near.inside || distance < within) return none;
  const Vec3<T> normal = (T(1) / distance) * near.away;
  return larger(T(0), dot(way_before, normal)) * normal;
}

/// The surface at the thickness where a substep begins.
template <class T>
struct StartOnMesh {
  Vec3<T> normal;
  T depth;  ///< m below the thickness; negative above it
};
/// For a particle that a plain contact pushes: over the same face it is that of the contact, and so
/// it is where the start tells nothing.
template <class T>
WEFT_HD_COLD StartOnMesh<T> start_on_mesh(const TriangleGrid<T>& grid, Vec3<T> p0,
                                          const MeshContact<T>& contact,
                                          const NearMemory<T>& memory, int32_t mesh) {
  if (!contact.plain || contact.stopped) return {contact.normal, T(0)};
  if (contact.over >= 0) {
    T value[4];
    plane_values(grid.planes[contact.over], p0, value);
    const bool same_face = larger(larger(value[1], value[2]), value[3]) <= T(0);
    const T height = dot(contact.normal, p0 - grid.corners[contact.over].corner[0]);
    if (same_face && height > T(0)) return {contact.normal, grid.thickness - height};
  }
  const Nearest<T> near = nearest_about(grid, p0, memory, mesh);
  const T distance = square_root(near.distance2);
  if (near.triangle < 0 || near.inside || !(distance > T(1e-3) * grid.thickness)) {
    return {contact.normal, T(0)};
  }
  return {(T(1) / distance) * near.away, grid.thickness - distance};
}

}  // namespace WEFT_BACKEND_NS
}  // namespace weft
