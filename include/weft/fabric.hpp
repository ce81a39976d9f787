// Fabrics: cooked, immutable, shareable descriptions of a deformable surface. A cloth is an
// instance of a fabric (weft/world.hpp).
#pragma once

#include "weft/core.hpp"

namespace weft {
inline namespace v0 {

/// Spring stiffness by class, N/m, each >= 0. The force of a spring on its end i towards j is
/// k (l - l0)/l (x_j - x_i): Georgii and Westermann 2005, eq. (1), with the sign it means.
struct Stiffness {
  double stretch = 100;  ///< grid: axial neighbours; mesh: edges
  double shear = 100;    ///< grid: diagonal neighbours
  double bend = 100;     ///< grid: neighbours two apart; mesh: across an edge

  constexpr Stiffness() = default;
  constexpr Stiffness(double all) : stretch(all), shear(all), bend(all) {}
  constexpr Stiffness(double stretch_, double shear_, double bend_)
      : stretch(stretch_), shear(shear_), bend(bend_) {}
};

/// Mass of the vertices; exactly one way of giving it.
struct Mass {
  enum class Kind : uint8_t {
    total,      ///< `value` kg, shared equally by all vertices
    density,    ///< `value` kg/m^2, a third of each triangle's mass to each of its vertices
    per_vertex  ///< `values`, kg, one per vertex, each > 0; infinite: the vertex never moves
  };
  Kind kind = Kind::total;
  double value = 1.0;  ///< > 0
  View<double> values;
};

/// Every rest length is the distance in the rest shape.
constexpr double initial_rest_length = -1;

/// What fabrics of every topology have.
struct Material {
  Stiffness stiffness;
  double rest_length = initial_rest_length;  ///< m, >= 0, for every spring; or initial
  Mass mass;
  double scale = 1;  ///< > 0; multiplies the rest shape, never a given rest length
};

/// Neighbours of a grid vertex as (row, column) offsets.
enum class Stencil : uint8_t {
  seed12,     ///< (+-1,0) (0,+-1) (+-1,+-1) (+-2,+-2): Fratarcangeli 2011, figure 22.2
  classic12,  ///< (+-1,0) (0,+-1) (+-1,+-1) (+-2,0) (0,+-2)
  quad4,      ///< (+-1,0) (0,+-1)
  tri6        ///< quad4 and (1,1) (-1,-1): the valence-6 triangulation
};
WEFT_API const char* to_string(Stencil) noexcept;

/// A grid of rows x columns vertices. Vertex r*columns + c sits at
/// (c*width/(columns-1), r*height/(rows-1), 0); a single row or column sits at 0. Topology is
/// implicit: springs cost no memory. Triangles: each quad split along (1,1).
struct GridDesc {
  uint32_t rows = 2, columns = 2;  ///< >= 1, rows*columns <= 2^30
  double width = 1, height = 1;    ///< m, > 0
  Stencil stencil = Stencil::seed12;
  Material material;
};

/// One spring of a network, or beside the edges of a mesh. `stiffness` N/m and `rest_length` m
/// override the material when >= 0.
struct Spring {
  uint32_t a = 0, b = 0;
  double stiffness = -1;
  double rest_length = -1;
};

/// Triangles over vertices: a stretch spring per unique edge and, with `bend`, a bend spring
/// between the opposite vertices of each edge that has exactly two triangles. A triangle that is
/// given again, the same way or the other way round, counts once, and is reported; of two ways the
/// one that fits its neighbours counts, else the first.
struct MeshDesc {
  PointView positions;     ///< m, rest shape
  View<uint32_t> indices;  ///< 3 per triangle, each below positions.count, three different ones
  bool bend = false;
  Material material;
  /// m, in the rest shape; above 0, vertices nearer than this are one particle, as at the seams of
  /// a render mesh. Pins, forces, velocities, positions and what is read are then by particle
  /// (Fabric::read_particles); outputs are by vertex of `positions`, as ever. A triangle that loses
  /// a corner is left out, and reported. Masses per vertex: a particle has its first vertex's.
  double weld_distance = 0;
  /// More springs between the vertices, a != b, as an OBJ file has lines beside its faces. One
  /// without a stiffness has the stretch stiffness. What an edge or an earlier spring joins already
  /// is left out, and reported.
  View<Spring> springs;
};

/// Any graph of springs, without triangles.
struct NetworkDesc {
  PointView positions;
  View<Spring> springs;  ///< a != b; a spring listed twice is merged with the first, and reported
  Material material;
};

/// Something worth knowing about a fabric that is not an error: "edge 3-7 is listed twice ...".
struct Diagnostic {
  Severity severity = Severity::info;
  uint32_t element = 0;  ///< vertex, triangle or spring, as the text says
  const char* text = nullptr;
};

/// Shared ownership of a cooked fabric; a copy is another reference, and references may be used
/// from any thread. An empty fabric has no vertices.
class WEFT_API Fabric {
 public:
  Fabric() noexcept = default;
  Fabric(const Fabric&) noexcept;
  Fabric(Fabric&&) noexcept;
  Fabric& operator=(Fabric) noexcept;
  ~Fabric();

  uint32_t vertex_count() const noexcept;  ///< particles; of welded meshes fewer than were given
  uint32_t render_vertex_count() const noexcept;  ///< as given: what an output writes
  /// The particle of each of the vertices that were given; `out` has room for them.
  Status read_particles(uint32_t* out) const noexcept;
  uint64_t spring_count() const noexcept;    ///< unique, undirected
  uint64_t triangle_count() const noexcept;  ///< none for a network
  /// Writes 3 vertex indices for each of triangles [first, first + count) to `out`.
  Status read_triangles(uint64_t first, uint64_t count, uint32_t* out) const noexcept;
  /// What cooking reported; valid as long as a reference to this fabric lives.
  View<Diagnostic> diagnostics() const noexcept;

  struct Impl;
  explicit Fabric(Impl* cooked) noexcept : impl_(cooked) {}
  const Impl* impl() const noexcept { return impl_; }

 private:
  Impl* impl_ = nullptr;
};

/// Triangles that cloth collides with, of any number. One that is given again counts once, as in
/// MeshDesc. A closed mesh may have several pieces, judged one by one: triangles that share edges
/// make a piece. One that is inside out is a cavity of the piece round it, and refused elsewhere.
struct ColliderMeshDesc {
  PointView positions;       ///< m, in the mesh's own frame
  View<uint32_t> indices;    ///< 3 per triangle, counterclockwise from outside when `closed`
  double scale = 1;          ///< > 0; multiplies the positions, not the thickness
  double thickness = 0.005;  ///< m, > 0: the distance that particles keep from the triangles
  bool closed = false;  ///< has an inside; every edge then has two triangles, oppositely directed
  /// m, scaled; vertices nearer than this are one. At 0, those that rounding parts are one: within
  /// 2^-46 of the largest coordinate, and at the rim of a hole in a closed mesh within 2^-22 of it.
  double weld_distance = 0;
};

/// Shared ownership of a cooked collider mesh, as Fabric. An empty one has no triangles.
class WEFT_API ColliderMesh {
 public:
  ColliderMesh() noexcept = default;
  ColliderMesh(const ColliderMesh&) noexcept;
  ColliderMesh(ColliderMesh&&) noexcept;
  ColliderMesh& operator=(ColliderMesh) noexcept;
  ~ColliderMesh();

  uint64_t triangle_count() const noexcept;
  uint64_t bytes() const noexcept;  ///< that a world keeps on the device for it
  View<Diagnostic> diagnostics() const noexcept;

  struct Impl;
  explicit ColliderMesh(Impl* cooked) noexcept : impl_(cooked) {}
  const Impl* impl() const noexcept { return impl_; }

 private:
  Impl* impl_ = nullptr;
};

}  // namespace v0
}  // namespace weft
