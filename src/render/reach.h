// How deep flat triangles between particles reach into the colliders that keep the particles out.
#pragma once

#include "render/box.h"

#include "io/scene.h"
#include "io/surface.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace weft::render {

/// How far a point is inside of a shape, m, negative outside, and in which direction that grows.
/// Concave over all of space, with |slope| <= 1.
struct Depth {
  double value;
  Eigen::Vector3d slope;
};

/// Of a point at `time` s. None for planes, which flat triangles cannot enter, and for meshes.
std::optional<Depth> depth_in(const io::ColliderScene&, double time, const Eigen::Vector3d& point);

/// Gathers moments of a run.
class Reach {
 public:
  /// `start` has the topology of what is added.
  Reach(const io::Scene&, const io::Surface& start);

  /// Triangles, and the bars of what has none.
  void add(const io::Surface&, double time);

  /// m, by collider: no triangle went deeper below its own deepest corner. Too much by a fiftieth
  /// of an edge at most. For planes and meshes 0.
  const std::vector<double>& depths() const { return depths_; }
  /// Of shapes that show through cloth, although they are drawn smaller or because it started in
  /// them: a line each, with path, reason and remedy.
  std::vector<std::string> problems() const;

 private:
  const io::Scene& scene_;
  std::vector<std::array<uint32_t, 2>> bars_;
  std::vector<double> depths_;
  std::vector<bool> holds_start_;  ///< by collider: cloth starts inside of it, and not by a hair
};

}  // namespace weft::render
