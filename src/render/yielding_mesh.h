// A collider mesh that gives way to the cloth on it, picture by picture.
#pragma once

#include "render/creases.h"
#include "render/model.h"
#include "render/ridges.h"

#include "io/scene.h"
#include "io/surface.h"

#include <map>
#include <memory>
#include <tuple>

namespace weft::render {

class YieldingMesh {
 public:
  /// What colliders of one mesh, scale and kind share.
  struct Shape {
    explicit Shape(const io::MeshColliderScene&);
    io::Mesh mesh;  ///< of the file, in pieces
    Ridges ridges;
    Creased drawn;  ///< where the file has it
    Model model;
  };
  using Key = std::tuple<const io::Mesh*, double, bool>;
  using Shapes = std::map<Key, std::shared_ptr<const Shape>>;

  YieldingMesh(const io::MeshColliderScene&, Shapes&);

  /// To the triangles of a surface at `time` s.
  void update(const io::Surface&, double time);
  void draw() const;
  /// Whether cloth was cut in some update and the mesh could not give way.
  bool shows() const { return shows_; }

 private:
  std::shared_ptr<const Shape> shape_;
  Eigen::Matrix3d turn_;
  Vector3d place_, velocity_;
  double scale_;
  std::unique_ptr<Model> moved_;  ///< null: no triangle cuts it
  bool shows_ = false;
};

/// What the collider meshes of a scene take while they are drawn, as measured and rounded up.
uint64_t bytes_of_meshes(const io::Scene&);

}  // namespace weft::render
