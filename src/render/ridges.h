// Where the edges of a collider mesh stick out of the flat triangles of a cloth on it, and how a
// mesh is drawn so that they do not.
#pragma once

#include "render/box_tree.h"

#include "io/mesh.h"

#include <array>
#include <vector>

namespace weft::render {

/// A mesh rises out of a triangle whose corners are outside of it at convex edges only. Also one
/// with holes, as long as it goes round something.
class Ridges {
 public:
  /// Points of it, and all that it is asked about, are where the mesh is before it is turned and
  /// moved, but scaled.
  Ridges(const io::Mesh&, double scale, bool closed);

  /// m, by edge of the mesh and then by vertex: with the faces around it moved in by this it is
  /// below all triangles.
  using Depths = std::vector<double>;
  Depths no_depths() const { return Depths(edges_.size() + points_.size(), 0); }
  /// Looks at one more triangle of a cloth.
  void add(const std::array<Vector3d, 3>& triangle, Depths& depths) const;

  struct Inset {
    std::vector<Vector3d> by;  ///< m, by vertex of the file: where it is drawn lies inwards by it
    bool enough = true;        ///< false: the mesh is too thin somewhere, or has no outside, and
                               ///< stays as it is there
  };
  /// How to draw the mesh so that no triangle lies in it.
  Inset inset(const Depths&) const;

  /// Whether a point is inside of the mesh, which is closed.
  bool enclose(const Vector3d& point) const;

 private:
  struct Edge {
    Vector3d a, b;
    uint32_t from, to;  ///< welded vertices
    Vector3d out;       ///< mean normal of its triangles, unit; zero: unknown
    double flat;        ///< length of the mean before: 1 when they lie in one plane
  };
  struct Outward {
    Vector3d normal{0, 0, 0};  ///< unit, to the outside
    double least = 1;          ///< cosine to the normal of a triangle, or the least that is used
  };

  void find_outside(bool closed);
  void find_edges();
  void find_outward();
  double depth_of(uint32_t vertex, const std::array<Vector3d, 3>& triangle, double farthest) const;
  double depth_below(const Edge&, const std::array<Vector3d, 3>& triangle, double most) const;
  bool is_crossed(const std::array<Vector3d, 3>& triangle, const Box& around) const;
  /// m from `from` to the first triangle of the mesh towards `to`; 1e300 when there is none. Those
  /// at `from` do not count.
  double first_crossing(const Vector3d& from, const Vector3d& to) const;

  std::vector<uint32_t> welded_;   ///< by vertex of the file: the number of the first in its place
  std::vector<uint32_t> corner_;   ///< welded vertices, three per triangle
  std::vector<Vector3d> points_;   ///< by vertex of the file, scaled
  std::vector<Vector3d> corners_;  ///< three per triangle
  std::vector<Outward> outward_;   ///< by welded vertex
  std::vector<Edge> edges_;
  Box box_;
  BoxTree near_edges_, near_triangles_, near_points_;
  double outside_ = 0;  ///< 1 where the normals of its triangles point, -1 against them, 0 on both
};

}  // namespace weft::render
