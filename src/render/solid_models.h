// Colliders on the device.
#pragma once

#include "render/model.h"
#include "render/solids.h"
#include "render/yielding_mesh.h"

#include <array>
#include <string>
#include <vector>

namespace weft::render {

/// Many capsules by one call.
class CapsuleModels {
 public:
  /// `corners` around each, a multiple of 4.
  explicit CapsuleModels(uint32_t corners);
  /// Ends relative to the picture's origin, and radius.
  void fill(const std::vector<std::array<float, 7>>&);
  void draw() const;

 private:
  Model form_;
  Buffer instances_;
  size_t count_ = 0;
};

class SolidModels {
 public:
  SolidModels(const Solids&, const io::Scene&);
  /// Collider meshes give way to the surface.
  void update(const io::Surface&, double time, const Vector3d& origin);
  /// Of collider meshes that show through cloth: a line each, with path, reason and remedy.
  std::vector<std::string> problems() const;
  /// All but the discs.
  void draw_solids(const Program&) const;
  /// Those that face `eye`: a plane hides nothing from behind.
  void draw_discs(const Program&, const Vector3f& eye) const;
  void draw_capsules(const Program&) const;

 private:
  void draw(const Program&, size_t solid) const;

  Solids solids_;
  std::array<Model, 3> forms_{Model(cylinder_form()), Model(box_form()), Model(disc_form())};
  std::vector<Model> meshes_;
  std::vector<YieldingMesh> collider_meshes_;
  CapsuleModels capsules_{48};
  std::vector<Eigen::Matrix4f> places_;  ///< of the solids, now
};

}  // namespace weft::render
