#include <algorithm>
#include <cmath>

#include "base/message_host.h"
#include "scene/check.h"
#include "scene/collider_mesh_parts.h"

namespace weft::scene {

using namespace WEFT_BACKEND_NS;

Point corner_of(const CookedColliderMesh& mesh, uint32_t triangle, int corner) {
  const double* p = &mesh.corners[size_t(triangle) * 9 + size_t(corner) * 3];
  return {p[0], p[1], p[2]};
}
Point normal_of(const CookedColliderMesh& mesh, uint32_t triangle) {
  const double* p = &mesh.planes[size_t(triangle) * 16];
  return {p[0], p[4], p[8]};
}

/// By regions of the triangle (Ericson, Real-Time Collision Detection, section 5.1.5).
NearestPoint nearest_point(const double* corners, Point x) {
  const Point a{corners[0], corners[1], corners[2]}, b{corners[3], corners[4], corners[5]},
      c{corners[6], corners[7], corners[8]};
  const Point ab = b - a, ac = c - a, ap = x - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {a, 3};
  const Point bp = x - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {b, 4};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + (d1 / (d1 - d3)) * ab, 0};
  const Point cp = x - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {c, 5};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + (d2 / (d2 - d6)) * ac, 2};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return {b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b), 1};
  }
  const double scale = 1 / (va + vb + vc);
  return {a + ((vb * scale) * ab + (vc * scale) * ac), -1};
}

namespace {

constexpr uint32_t most_triangles = 1u << 30;
/// Of a triangle's longest side: what is flatter has no normal to speak of.
constexpr double least_height = 1e-10;

Point point(double3 p) { return {p.x, p.y, p.z}; }

void check_indices(const ColliderMeshDesc& desc) {
  check_view(desc.indices, "indices");
  if (desc.indices.count % 3 != 0) {
    throw InvalidInput(text("indices has %u elements (three make a triangle) give a multiple of 3",
                            desc.indices.count));
  }
  if (desc.indices.count / 3 > most_triangles) {
    throw InvalidInput(text("indices has %u elements (a mesh has at most 2^30 triangles) split it",
                            desc.indices.count));
  }
  for (uint32_t i = 0; i < desc.indices.count; ++i) {
    if (desc.indices[i] >= desc.positions.count) {
      throw InvalidInput(
          text("triangle %u names vertex %u (the mesh has %u) give an index below that", i / 3,
               desc.indices[i], desc.positions.count));
    }
  }
}

/// Checked twice: as given, and scaled.
Vector<double3> scaled_positions(const ColliderMeshDesc& desc) {
  check_positions(desc.positions, "positions");
  check_positive(desc.scale, "scale");
  Vector<double3> scaled(desc.positions.count);
  for (uint32_t v = 0; v < desc.positions.count; ++v) {
    const double3 x = desc.positions[v];
    scaled[v] = {x.x * desc.scale, x.y * desc.scale, x.z * desc.scale};
  }
  check_positions(View<double3>(scaled), "positions times scale");
  return scaled;
}

/// Appends corners and planes; false if the triangle has no area.
bool add_triangle(const Point (&corner)[3], CookedColliderMesh& mesh) {
  Point edge[3];
  double longest = 0;
  for (int c = 0; c < 3; ++c) {
    edge[c] = corner[(c + 1) % 3] - corner[c];
    longest = std::max(longest, length(edge[c]));
  }
  const Point area = cross(edge[0], edge[1]);
  const double twice_area = length(area);
  if (!(twice_area > least_height * longest * longest)) return false;

  const Point normal = (1 / twice_area) * area;
  Point plane[4] = {normal, {}, {}, {}};
  double offset[4] = {dot(normal, corner[0]), 0, 0, 0};
  for (int c = 0; c < 3; ++c) {
    const Point outward = cross(edge[c], normal);
    plane[c + 1] = (1 / length(outward)) * outward;
    offset[c + 1] = dot(plane[c + 1], corner[c]);
  }
  for (const Point& p : plane) mesh.planes.push_back(p.x);
  for (const Point& p : plane) mesh.planes.push_back(p.y);
  for (const Point& p : plane) mesh.planes.push_back(p.z);
  mesh.planes.insert(mesh.planes.end(), offset, offset + 4);
  for (const Point& p : corner) mesh.corners.insert(mesh.corners.end(), {p.x, p.y, p.z});
  ++mesh.triangles;
  return true;
}

/// Takes those that have no area from the surface.
void add_triangles(Surface& surface, CookedColliderMesh& mesh) {
  const uint32_t count = surface.triangles();
  mesh.triangles = 0;
  mesh.planes.clear();
  mesh.corners.clear();
  mesh.planes.reserve(size_t(count) * 16);
  mesh.corners.reserve(size_t(count) * 9);
  uint32_t flat = 0, first_flat = 0, kept = 0;
  for (uint32_t t = 0; t < count; ++t) {
    const uint32_t* v = &surface.vertex[3 * size_t(t)];
    const Point corner[3] = {point(surface.positions[v[0]]), point(surface.positions[v[1]]),
                             point(surface.positions[v[2]])};
    if (add_triangle(corner, mesh)) {
      std::copy(v, v + 3, &surface.vertex[3 * size_t(kept)]);
      surface.given[kept++] = surface.given[t];
    } else if (flat++ == 0) {
      first_flat = surface.given[t];
    }
  }
  surface.vertex.resize(3 * size_t(kept));
  surface.given.resize(kept);
  if (flat > 0) {
    mesh.diagnostics.push_back(
        {Severity::warning, first_flat,
         text("%u triangles have no area, the first is %u: they are left out", flat, first_flat)});
  }
}

void check_areas(const ColliderMeshDesc& desc, const Surface& surface) {
  CookedColliderMesh one(std::pmr::new_delete_resource());
  for (uint32_t t = 0; t < surface.triangles(); ++t) {
    const uint32_t* v = &surface.vertex[3 * size_t(t)];
    const Point corner[3] = {point(surface.positions[v[0]]), point(surface.positions[v[1]]),
                             point(surface.positions[v[2]])};
    if (add_triangle(corner, one)) return;
  }
  throw InvalidInput(
      text("the collider mesh has %u triangles and none has an area (there is nothing to collide "
           "with) give triangles of three different points",
           desc.indices.count / 3));
}

}  // namespace

/// The way of a fast particle through the mesh is walked in a bounded number of pieces.
static void check_extent(const Vector<double3>& positions, double thickness) {
  constexpr double most_thicknesses = 1 << 19;
  double3 low = positions[0], high = positions[0];
  for (const double3& p : positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double x = high.x - low.x, y = high.y - low.y, z = high.z - low.z;
  const double size = std::sqrt(x * x + y * y + z * z);
  if (size <= most_thicknesses * thickness) return;
  throw InvalidInput(
      text("thickness is %g (the mesh is %g m across: fast particles would pass through) give at "
           "least %g",
           thickness, size, size / most_thicknesses));
}

/// The middle of what is further from zero than it is large.
static double3 origin_of(const Vector<double3>& positions) {
  if (positions.empty()) return {0, 0, 0};
  double3 low = positions.front(), high = low;
  for (const double3& x : positions) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const auto whole = [size](double a, double b) {
    const double middle = a / 2 + b / 2;
    return std::fabs(middle) > 2 * size + 1 ? std::nearbyint(middle) : 0;
  };
  return {whole(low.x, high.x), whole(low.y, high.y), whole(low.z, high.z)};
}

void cook_collider_mesh(const ColliderMeshDesc& desc, CookedColliderMesh& mesh) {
  check_positive(desc.thickness, "thickness");
  check_indices(desc);
  check_not_negative(desc.weld_distance, "weld_distance");
  Vector<double3> positions = scaled_positions(desc);
  mesh.thickness = desc.thickness;
  mesh.closed = desc.closed;
  Vector<uint32_t> indices(desc.indices.count);
  for (uint32_t i = 0; i < desc.indices.count; ++i) indices[i] = desc.indices[i];
  Surface surface = make_surface(std::move(positions), indices, desc.weld_distance, desc.closed,
                                 mesh.diagnostics);
  mesh.origin = origin_of(surface.positions);
  for (double3& x : surface.positions) {
    x = {x.x - mesh.origin.x, x.y - mesh.origin.y, x.z - mesh.origin.z};
  }
  check_areas(desc, surface);
  check_extent(surface.positions, desc.thickness);
  if (desc.closed) check_closed(surface);
  add_triangles(surface, mesh);
  if (desc.closed) set_sides(surface, mesh);
  build_grid(mesh);
}

}  // namespace weft::scene
