#include "render/targets.h"

#include <algorithm>

namespace weft::render {
namespace {

void allocate_texture(const Texture& texture, GLenum inner, int size, GLenum format, GLenum type) {
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GLint(inner), size, size, 0, format, type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void attach_texture(const Framebuffer& target, GLenum place, const Texture& texture) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, texture.name(), 0);
}

void attach_buffer(GLenum place, const Renderbuffer& buffer, int samples, GLenum format,
                   uint32_t width, uint32_t height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, GLsizei(width),
                                   GLsizei(height));
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer.name());
}

void bind_texture(GLenum unit, const Texture& texture) {
  glActiveTexture(unit);
  glBindTexture(GL_TEXTURE_2D, texture.name());
}

}  // namespace

ShadowMap::ShadowMap() {
  allocate_texture(depth_, GL_DEPTH_COMPONENT24, size, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  allocate_texture(half_done_, GL_R8, soft_size, GL_RED, GL_UNSIGNED_BYTE);
  allocate_texture(soft_, GL_R8, soft_size, GL_RED, GL_UNSIGNED_BYTE);
  attach_texture(depth_target_, GL_DEPTH_ATTACHMENT, depth_);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  require_framebuffer("a depth texture");
  attach_texture(half_target_, GL_COLOR_ATTACHMENT0, half_done_);
  attach_texture(soft_target_, GL_COLOR_ATTACHMENT0, soft_);
  require_framebuffer("a texture");
}

void ShadowMap::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, depth_target_.name());
  glViewport(0, 0, size, size);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2, 4);
  glClear(GL_DEPTH_BUFFER_BIT);
}

void ShadowMap::soften(const Program& blur, const VertexArray& nothing) const {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glViewport(0, 0, soft_size, soft_size);
  glBindVertexArray(nothing.name());
  blur.use();
  blur.set("depth", 0);
  blur.set("half_done", 1);
  bind_texture(GL_TEXTURE0, depth_);
  bind_texture(GL_TEXTURE1, half_done_);
  for (const bool first : {true, false}) {
    glBindFramebuffer(GL_FRAMEBUFFER, (first ? half_target_ : soft_target_).name());
    blur.set("first", int(first));
    const float step = 1.0f / soft_size;
    blur.set("step_by", Eigen::Vector3f(first ? step : 0, first ? 0 : step, 0));
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
}

void ShadowMap::bind() const {
  bind_texture(GL_TEXTURE0, depth_);
  bind_texture(GL_TEXTURE1, soft_);
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
