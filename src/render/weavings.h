// Cloths on the device.
#pragma once

#include "render/solid_models.h"
#include "render/stage.h"
#include "render/weave.h"

#include "io/scene.h"
#include "io/surface.h"

#include <array>
#include <vector>

namespace weft::render {

class Weavings {
 public:
  Weavings(const io::Scene&, const io::Surface& start, const Stage&);
  void update(const io::Surface&, const Vector3d& origin);
  void draw_cloths(const Program&) const;
  void draw_bars(const Program&) const;

 private:
  struct Part {
    size_t first_index, index_count;
    float threads, stripes;  ///< per metre
  };
  VertexArray array_;
  Buffer moving_, weave_, indices_;
  std::vector<Part> parts_;
  std::vector<std::array<uint32_t, 2>> bars_;
  CapsuleModels bar_models_;
  float bar_radius_;
  std::vector<std::array<float, 6>> vertices_;  ///< position, normal: kept for its memory
};

}  // namespace weft::render
