// What is drawn to: the shadow map, its blurred copy, and the picture.
#pragma once

#include "render/gl.h"
#include "render/image.h"

namespace weft::render {

/// Depth from the light's side, compared when it is read.
class ShadowMap {
 public:
  static constexpr int size = 1024, soft_size = 128;

  ShadowMap();
  void begin() const;  ///< the next draws go to the map
  /// Fills the soft copy; `blur` runs twice over a vertex array without attributes.
  void soften(const Program& blur, const VertexArray& nothing) const;
  void bind() const;  ///< unit 0: the map; unit 1: its soft copy

 private:
  Texture depth_, half_done_, soft_;
  Framebuffer depth_target_, half_target_, soft_target_;
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
