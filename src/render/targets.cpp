#include "render/targets.h"

#include <algorithm>

namespace weft::render {
namespace {

void attach_buffer(GLenum place, const Renderbuffer& buffer, int samples, GLenum format,
                   uint32_t width, uint32_t height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, GLsizei(width),
                                   GLsizei(height));
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer.name());
}

}  // namespace

ShadowMap::ShadowMap() {
  glBindTexture(GL_TEXTURE_2D, depth_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT,
               GL_UNSIGNED_INT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  require_framebuffer("a depth texture");
}

void ShadowMap::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
  glViewport(0, 0, size, size);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2, 4);
  glClear(GL_DEPTH_BUFFER_BIT);
}

Canvas::Canvas(uint32_t width, uint32_t height) : width_(width), height_(height) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const int samples = std::min(most, 4);
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  attach_buffer(GL_COLOR_ATTACHMENT0, colour_, samples, GL_RGBA8, width, height);
  attach_buffer(GL_DEPTH_ATTACHMENT, depth_, samples, GL_DEPTH_COMPONENT24, width, height);
  require_framebuffer("a picture of this size");
  glBindFramebuffer(GL_FRAMEBUFFER, readable_.name());
  attach_buffer(GL_COLOR_ATTACHMENT0, resolved_, 0, GL_RGBA8, width, height);
  require_framebuffer("a picture of this size");
}

void Canvas::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.name());
  glViewport(0, 0, GLsizei(width_), GLsizei(height_));
  glDisable(GL_POLYGON_OFFSET_FILL);
  glClear(GL_DEPTH_BUFFER_BIT);
}

Image Canvas::read() const {
  const auto w = GLsizei(width_), h = GLsizei(height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, readable_.name());
  glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, readable_.name());
  Image image{width_, height_, std::vector<uint8_t>(size_t(width_) * height_ * 3)};
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, w, h, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  const size_t row = size_t(width_) * 3;  // OpenGL's first row is the lowest
  for (size_t low = 0, high = height_ - 1; low < high; ++low, --high) {
    const auto begin = image.rgb.begin();
    std::swap_ranges(begin + ptrdiff_t(low * row), begin + ptrdiff_t((low + 1) * row),
                     begin + ptrdiff_t(high * row));
  }
  return image;
}

}  // namespace weft::render
