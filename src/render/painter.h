// Draws the state of a scene.
#pragma once

#include "render/framing.h"
#include "render/image.h"
#include "render/reach.h"

#include <memory>
#include <string>
#include <vector>

namespace weft::render {

/// A scene as it looks from one camera. Needs a Session on this thread that outlives it.
class Painter {
 public:
  /// `start`: the surface of the first picture, with normals. Keeps a reference to nothing.
  Painter(const io::Scene&, const io::Surface& start, const Framing&, const Reach&);
  ~Painter();

  /// `surface`: as `start`, with new positions and normals; `time` in seconds places the colliders.
  Image draw(const io::Surface& surface, double time);

  /// What is wrong with the pictures so far: a line each, with path, reason and remedy.
  std::vector<std::string> problems() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace weft::render
