// What is drawn to: the shadow map and the picture.
#pragma once

#include "render/gl.h"
#include "render/image.h"

namespace weft::render {

/// Depth from the light's side, compared when it is read; the texture of unit 0.
class ShadowMap {
 public:
  static constexpr int size = 1024;

  ShadowMap();
  void begin() const;  ///< the next draws go to the map

 private:
  Texture depth_;
  Framebuffer target_;
};

/// Four samples per pixel where the driver has them.
class Canvas {
 public:
  Canvas(uint32_t width, uint32_t height);
  void begin() const;
  Image read() const;

 private:
  uint32_t width_, height_;
  Renderbuffer colour_, depth_, resolved_;
  Framebuffer drawn_, readable_;
};

}  // namespace weft::render
