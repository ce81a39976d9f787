// The colliders of a scene as triangles.
#pragma once

#include "render/box.h"

#include "io/scene.h"

#include <cstdint>
#include <vector>

namespace weft::render {

/// In world coordinates. Counterclockwise as seen from outside.
struct Triangles {
  std::vector<Vector3d> places, normals;  ///< by vertex
  std::vector<uint32_t> indices;          ///< three each
};

/// A collider at the start.
struct Solid {
  enum class Kind : uint8_t { body, plane, ground };
  Triangles surface;
  Vector3d velocity{0, 0, 0};
  Kind kind = Kind::body;  ///< ground: the plane that faces up the most, by 45 degrees at least
  Box box;                 ///< of its surface
};

/// Against gravity; without any, along y.
Vector3d up_of(const io::Scene&);

/// Planes are discs around `region`, three times as large; spheres much larger than it are fine
/// where they are near it.
std::vector<Solid> make_solids(const io::Scene&, const Box& region);

/// All within `radius` of the segment from `a` to `b`, with so many corners around it, a multiple
/// of four.
Triangles capsule(const Vector3d& a, const Vector3d& b, double radius, uint32_t corners);

/// Triangles of three `indices` each. A vertex has one normal for those around it that lie within
/// 40 degrees of each other.
Triangles with_creases(const std::vector<Vector3d>& places, const std::vector<uint32_t>& indices);

}  // namespace weft::render
