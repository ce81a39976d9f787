// What lies in one place becomes one vertex, and what is given twice one triangle.
#include <algorithm>
#include <cmath>

#include "base/message_host.h"
#include "scene/collider_mesh_parts.h"
#include "scene/faces.h"
#include "scene/places.h"

namespace weft::scene {

namespace {

/// Of the largest coordinate: double arithmetic, and numbers of single precision.
constexpr double rounding = 0x1p-46, coarse_rounding = 0x1p-22;
/// Two vertices of a mesh are hardly ever within a thousand roundings.
constexpr double wide = 1024;

double largest_coordinate_of(const Vector<double3>& positions) {
  double most = 0;
  for (const double3& p : positions) {
    most = std::max({most, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  return most;
}

/// Welds the vertices that are marked, or all.
void weld(Surface& surface, double distance, double cell, const Vector<bool>& marked) {
  if (!(distance > 0)) return;
  Places places(distance, cell);
  Vector<uint32_t> first;  // vertex, by place
  Vector<uint32_t> becomes(surface.positions.size());
  for (uint32_t v = 0; v < becomes.size(); ++v) {
    becomes[v] = v;
    const uint32_t w = surface.welded[v];
    if (w != v || (!marked.empty() && !marked[v])) continue;
    const uint32_t place = places.of(surface.positions[v]);
    if (place == first.size()) first.push_back(v);
    becomes[v] = first[place];
  }
  for (uint32_t v = 0; v < becomes.size(); ++v) {
    surface.welded[v] = becomes[surface.welded[v]];
    surface.positions[v] = surface.positions[surface.welded[v]];
  }
}

/// Vertices of edges that have one triangle.
Vector<bool> rim(const Surface& surface) {
  const Vector<Side> sides = sorted_sides(surface);
  Vector<bool> marked;
  for (size_t first = 0; first < sides.size();) {
    const size_t end = end_of_edge(sides, first);
    if (end - first == 1) {
      marked.resize(surface.positions.size(), false);
      marked[sides[first].low] = marked[sides[first].high] = true;
    }
    first = end;
  }
  return marked;
}

void keep_distinct(Surface& surface, Vector<CookedDiagnostic>& diagnostics) {
  Vector<uint32_t> corners(surface.vertex.size());
  for (uint32_t c = 0; c < corners.size(); ++c) corners[c] = surface.place(c);
  Faces faces = distinct_faces(corners);
  if (faces.repeats == 0) return;
  diagnostics.push_back(
      {Severity::warning, surface.given[faces.first_repeat],
       text(
           "%u triangles are given again, the first is %u, which is triangle %u (each counts once) "
           "remove the copies",
           faces.repeats, surface.given[faces.first_repeat], surface.given[faces.its_like])});
  const Vector<bool> before = std::move(surface.both_ways);
  if (!before.empty()) faces.both_ways.resize(faces.kept.size(), false);
  for (size_t k = 0; k < faces.kept.size(); ++k) {
    const uint32_t t = faces.kept[k];
    if (!before.empty() && before[t]) faces.both_ways[k] = true;
    uint32_t* to = &surface.vertex[3 * k];
    std::copy_n(&surface.vertex[3 * size_t(t)], 3, to);
    if (faces.is_turned(k)) std::swap(to[1], to[2]);
    surface.given[k] = surface.given[t];
  }
  surface.vertex.resize(3 * faces.kept.size());
  surface.given.resize(faces.kept.size());
  surface.both_ways = std::move(faces.both_ways);
}

}  // namespace

Surface make_surface(Vector<double3> positions, const Vector<uint32_t>& indices,
                     double weld_distance, bool closed, Vector<CookedDiagnostic>& diagnostics) {
  Surface surface;
  surface.positions = std::move(positions);
  surface.vertex = indices;
  for (uint32_t v = 0; v < surface.positions.size(); ++v) surface.welded.push_back(v);
  for (uint32_t t = 0; t < indices.size() / 3; ++t) surface.given.push_back(t);
  const double most = largest_coordinate_of(surface.positions);
  const double hair = std::max(most * rounding, 0x1p-500);
  if (weld_distance > hair)
    weld(surface, weld_distance, weld_distance, {});
  else
    weld(surface, hair, wide * hair, {});
  keep_distinct(surface, diagnostics);
  if (!closed) return surface;
  const double coarse = most * coarse_rounding;
  const Vector<bool> marked = rim(surface);
  if (marked.empty() || weld_distance > coarse) return surface;
  weld(surface, coarse, coarse, marked);
  keep_distinct(surface, diagnostics);
  return surface;
}

}  // namespace weft::scene
