// Draws the state of a scene.
#pragma once

#include "render/image.h"

#include "io/scene.h"
#include "io/surface.h"

#include <memory>

namespace weft::render {

/// A scene as it looks from one camera. Needs a Session on this thread that outlives it.
class Painter {
 public:
  /// `start`: the surface of the first picture, with normals. Keeps a reference to nothing.
  Painter(const io::Scene&, const io::Surface& start);
  ~Painter();

  /// `surface`: as `start`, with new positions and normals; `time` in seconds places the colliders.
  Image draw(const io::Surface& surface, double time);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace weft::render
