// Where the edges of a collider mesh stick out of the flat triangles of a cloth on it.
#pragma once

#include "render/box.h"

#include "io/scene.h"

#include <array>
#include <vector>

namespace weft::render {

/// A mesh rises out of a triangle whose corners are outside of it at convex edges only.
class Ridges {
 public:
  explicit Ridges(const io::MeshColliderScene&);

  struct Found {
    double depth = 0;  ///< m: with its faces moved in by this a closed mesh is below all triangles
    bool cut = false;  ///< a triangle and the mesh cross
  };
  /// Looks at one more triangle, at `time`.
  void add(const std::array<Vector3d, 3>& corners, double time, Found& found) const;

  /// Whether a point is inside of the mesh, which is closed, at `time`.
  bool enclose(const Vector3d& point, double time) const;

  /// m. Depths up to here a picture can hide by drawing the mesh, which is closed, smaller: a
  /// fifth of a sphere's radius, of what is flat or thin less.
  double most_hidden() const { return most_hidden_; }

 private:
  struct Edge {
    Vector3d a, b;
    Vector3d out;  ///< mean normal of its triangles, unit; zero: unknown
    double flat;   ///< length of the mean before: 1 when they lie in one plane
  };
  /// Lists, by cell, of what has a box of its own.
  class Grid {
   public:
    void fill(const Box& all, const std::vector<Box>& boxes);
    /// Calls `use` with the numbers of all whose boxes may touch this one, some more than once,
    /// until it returns true.
    template <class Use>
    bool any_near(const Box&, Use use) const;

   private:
    using Range = std::array<std::array<int, 2>, 3>;
    Range cells_of(const Box&) const;
    template <class Use>
    bool any_cell(const Range&, Use use) const;

    Vector3d low_{0, 0, 0};
    double cell_ = 1;
    std::array<int, 3> cells_{1, 1, 1};
    std::vector<uint32_t> start_, numbers_;  ///< of cell c: numbers_[start_[c]], ...
  };

  void measure();
  void find_edges();
  void look_below(const Edge&, const std::array<Vector3d, 3>& triangle, double most, Found&) const;
  /// Whether a triangle of the mesh crosses the segment, farther than `least` from its start.
  bool crosses(const Vector3d& from, const Vector3d& to, double least) const;
  Vector3d local(const Vector3d& point, double time) const;

  std::vector<Vector3d> corners_;  ///< three per triangle
  std::vector<Edge> edges_;
  Box box_;
  double most_hidden_ = 0;
  Grid edge_grid_, triangle_grid_;
  bool closed_;
  Eigen::Matrix3d turn_;
  Vector3d place_, velocity_;
};

/// The vertices of a mesh with every face moved inwards by `by`, where no angle is too sharp.
std::vector<Vector3d> shrunk(const io::Mesh&, double by);

}  // namespace weft::render
