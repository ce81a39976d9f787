// Whether the triangles of a mesh enclose something, piece by piece.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/message_host.h"
#include "scene/collider_mesh_parts.h"
#include "scene/winding.h"

namespace weft::scene {

using namespace WEFT_BACKEND_NS;

namespace {

double distance(const Surface& s, uint32_t a, uint32_t b) {
  const double3 &p = s.positions[a], &q = s.positions[b];
  return length(Point{p.x - q.x, p.y - q.y, p.z - q.z});
}

/// Another edge with one triangle that lies beside the first, the other way round.
struct Seam {
  const Side* beside = nullptr;
  uint32_t vertex = 0, other = 0;  ///< those that are further apart
  double gap = 0;
};

Seam nearest_seam(const Surface& surface, const Vector<Side>& sides, const Side& open) {
  const uint32_t a = surface.vertex[open.corner], b = surface.vertex[next_corner(open.corner)];
  Seam best;
  best.gap = 0.25 * distance(surface, a, b);
  for (size_t first = 0; first < sides.size();) {
    const size_t end = end_of_edge(sides, first);
    const Side& side = sides[first];
    if (end - first == 1 && &side != &open) {
      const uint32_t c = surface.vertex[side.corner], d = surface.vertex[next_corner(side.corner)];
      const double begins = distance(surface, a, d), ends = distance(surface, b, c);
      const double gap = std::max(begins, ends);
      if (gap < best.gap) {
        best = {&side, begins >= ends ? a : b, begins >= ends ? d : c, gap};
      }
    }
    first = end;
  }
  return best;
}

[[noreturn]] void refuse_open(const Surface& surface, const Vector<Side>& sides, const Side& open) {
  const uint32_t a = surface.vertex[open.corner], b = surface.vertex[next_corner(open.corner)];
  const Seam seam = nearest_seam(surface, sides, open);
  if (seam.beside) {
    throw InvalidInput(
        text("edge %u-%u has triangle %u only, and edge %u-%u beside it triangle %u only: vertices "
             "%u and %u are %.3g m apart (a closed mesh has two triangles at every edge) give a "
             "weld_distance above that, or set closed to false",
             a, b, surface.given[open.corner / 3], surface.vertex[seam.beside->corner],
             surface.vertex[next_corner(seam.beside->corner)],
             surface.given[seam.beside->corner / 3], seam.vertex, seam.other, seam.gap));
  }
  throw InvalidInput(
      text("edge %u-%u has triangle %u only (a closed mesh has two at every edge) fill the hole "
           "or set closed to false",
           a, b, surface.given[open.corner / 3]));
}

/// The sides of the edge from `first` to `end`.
void check_edge(const Surface& surface, const Vector<Side>& sides, size_t first, size_t end) {
  const Side* side = &sides[first];
  const size_t count = end - first;
  if (count == 1) refuse_open(surface, sides, *side);
  const uint32_t a = surface.vertex[side->corner], b = surface.vertex[next_corner(side->corner)];
  const auto triangle = [&](size_t k) { return surface.given[side[k].corner / 3]; };
  const auto ascending = std::count_if(side, side + count, [](Side s) { return s.ascending; });
  if (count == 2 && ascending != 1) {
    throw InvalidInput(
        text("triangles %u and %u both run from vertex %u to vertex %u (in a closed mesh one runs "
             "each way, so that it has an inside) turn one of them round",
             triangle(0), triangle(1), a, b));
  }
  if (count > 2) {
    throw InvalidInput(
        text("edge %u-%u has %zu triangles, the first are %u, %u and %u (a closed mesh has two at "
             "every edge) take the others away or set closed to false",
             a, b, count, triangle(0), triangle(1), triangle(2)));
  }
}

/// Triangles that hang together by edges.
struct Pieces {
  Vector<uint32_t> of;     ///< by triangle: the first triangle of its piece
  Vector<double> volume;   ///< m^3, by piece, at its first triangle
  Vector<double> size;     ///< m^3: the sum without signs
  Vector<uint32_t> count;  ///< triangles
  Vector<bool> turnable;   ///< each of its triangles was given both ways
};

uint32_t root(Vector<uint32_t>& parent, uint32_t t) {
  while (parent[t] != t) {
    parent[t] = parent[parent[t]];
    t = parent[t];
  }
  return t;
}

Pieces find_pieces(const Surface& surface, const Vector<Side>& sides) {
  Pieces pieces;
  const uint32_t triangles = surface.triangles();
  pieces.of.resize(triangles);
  std::iota(pieces.of.begin(), pieces.of.end(), 0u);
  for (size_t s = 0; s + 1 < sides.size(); s += 2) {
    const uint32_t a = root(pieces.of, sides[s].corner / 3);
    const uint32_t b = root(pieces.of, sides[s + 1].corner / 3);
    pieces.of[std::max(a, b)] = std::min(a, b);
  }
  pieces.volume.assign(triangles, 0);
  pieces.size.assign(triangles, 0);
  pieces.count.assign(triangles, 0);
  pieces.turnable.assign(triangles, !surface.both_ways.empty());
  for (uint32_t t = 0; t < triangles; ++t) {
    const uint32_t piece = pieces.of[t] = root(pieces.of, t);
    const double3 origin = surface.positions[surface.vertex[3 * size_t(piece)]];
    Point corner[3];
    for (size_t i = 0; i < 3; ++i) {
      const double3 p = surface.positions[surface.vertex[3 * size_t(t) + i]];
      corner[i] = {p.x - origin.x, p.y - origin.y, p.z - origin.z};
    }
    const double part = dot(corner[0], cross(corner[1], corner[2])) / 6;
    pieces.volume[piece] += part;
    pieces.size[piece] += std::fabs(part);
    ++pieces.count[piece];
    if (!surface.both_ways.empty() && !surface.both_ways[t]) pieces.turnable[piece] = false;
  }
  return pieces;
}

bool is_inverted(const Pieces& pieces, uint32_t piece) {
  return pieces.volume[piece] < -1e-9 * pieces.size[piece];
}

/// True when it turned one. Pieces of triangles that were given both ways enclose what is in them.
bool turn_pieces(Surface& surface, Pieces& pieces) {
  bool any = false;
  for (uint32_t t = 0; t < surface.triangles(); ++t) {
    const uint32_t piece = pieces.of[t];
    if (!pieces.turnable[piece] || !is_inverted(pieces, piece)) continue;
    std::swap(surface.vertex[3 * size_t(t) + 1], surface.vertex[3 * size_t(t) + 2]);
    any = true;
  }
  for (uint32_t t = 0; t < surface.triangles(); ++t) {
    if (pieces.turnable[t]) pieces.volume[t] = std::fabs(pieces.volume[t]);
  }
  return any;
}

/// A cavity lies in what the other pieces enclose.
void check_cavities(const Surface& surface, const Pieces& pieces) {
  constexpr uint32_t most_probes = 256;
  Winding winding;
  Vector<uint32_t> seen(surface.triangles(), 0);
  for (uint32_t t = 0; t < surface.triangles(); ++t) {
    const uint32_t piece = pieces.of[t];
    if (!is_inverted(pieces, piece)) continue;
    const uint32_t every = 1 + (pieces.count[piece] - 1) / most_probes;
    if (seen[piece]++ % every != 0) continue;
    Point sum{0, 0, 0};
    for (size_t c = 0; c < 3; ++c) {
      const double3& p = surface.positions[surface.vertex[3 * size_t(t) + c]];
      sum = sum + Point{p.x, p.y, p.z};
    }
    winding.add({(1.0 / 3) * sum, t, piece, 0});
  }
  if (winding.empty()) return;
  winding.count(surface, pieces.of);
  for (const Probe& probe : winding.probes()) {
    if (probe.turns >= 1) continue;
    throw InvalidInput(
        text("the piece of triangle %u, of %u triangles, has a volume of %g m3 and does not lie in "
             "another piece (its triangles run clockwise seen from outside, so that its inside is "
             "out; a cavity lies in a piece) reverse the triangles of this piece",
             surface.given[probe.triangle], pieces.count[probe.piece], pieces.volume[probe.piece]));
  }
}

}  // namespace

bool check_closed(Surface& surface) {
  const Vector<Side> sides = sorted_sides(surface);
  for (size_t first = 0; first < sides.size();) {
    const size_t end = end_of_edge(sides, first);
    check_edge(surface, sides, first, end);
    first = end;
  }
  Pieces pieces = find_pieces(surface, sides);
  const bool turned = turn_pieces(surface, pieces);
  check_cavities(surface, pieces);
  return turned;
}

}  // namespace weft::scene
