// The colliders of a scene as shapes that can be drawn.
#pragma once

#include "render/box.h"

#include "io/scene.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace weft::render {

/// Triangles with a normal per vertex.
struct Triangles {
  std::vector<std::array<float, 6>> vertices;  ///< position, normal
  std::vector<uint32_t> indices;
};

/// All points within `radius` of the segment from `a` to `b`: a sphere where these are equal.
struct Capsule {
  Vector3d a, b;
  double radius;
  Vector3d velocity{0, 0, 0};
};
enum class Form : uint8_t { cylinder, box, disc, mesh, collider_mesh };
/// A unit form, placed.
struct Solid {
  Form form;
  Eigen::Matrix3d axes;  ///< columns: where the form's x, y, z go
  Vector3d center;
  Vector3d velocity;
  size_t mesh = 0;  ///< of `Solids::meshes` or `Solids::collider_meshes`
};
struct Solids {
  std::vector<Capsule> capsules;
  std::vector<Solid> solids;
  std::vector<Triangles> meshes;
  std::vector<size_t> collider_meshes;  ///< which colliders of the scene they are
};

/// At the start; of a plane, empty.
Box bounds_of(const io::ColliderScene&);

Vector3d velocity_of(const io::ColliderScene&);

/// The plane that faces `up` the most, by 45 degrees at least; null when none does.
const PlaneDesc* ground_plane(const io::Scene&, const Vector3d& up);

/// Of a unit vector along `axis`; without a direction, none.
Eigen::Matrix3d rotation(double3 axis, double degrees);

/// m: by how much a shape can be drawn smaller; of planes and meshes 0.
double most_given(const io::ColliderScene&);

/// Shapes are drawn smaller by `reach`, by collider, and by a hair, so that no triangle between
/// particles on their surface is hidden; at least half of a shape is left. Collider meshes give way
/// later. Planes other than `ground` are drawn as discs of the size of `region`, around it.
Solids make_solids(const io::Scene&, const std::vector<double>& reach, const Box& region,
                   const PlaneDesc* ground);

/// For drawing capsules, with so many corners `around`: (x, y, w) of a unit half sphere's points
/// around an axis, and on which end (0 or 1). Position and normal are one.
Triangles capsule_form(uint32_t around);
/// A unit sphere below the origin, which is its top. Rings of vertices lie the closer the nearer to
/// the top they are, the first at an angle of `finest`: for spheres of which the picture shows a
/// small part.
Triangles planet_form(double finest);
/// Radius 1 around z, from -1 to 1.
Triangles cylinder_form();
/// From -1 to 1 along each axis.
Triangles box_form();
/// Radius 1 in the plane z = 0.
Triangles disc_form();

}  // namespace weft::render
