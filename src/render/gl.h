// Owners of OpenGL objects, and the few calls that need more than one line.
#pragma once

#include <epoxy/gl.h>

#include <Eigen/Core>

#include <cstddef>
#include <initializer_list>
#include <utility>

namespace weft::render {

/// Deletes its object in the end. `Kind` is one of the structs below.
template <class Kind>
class Owned {
 public:
  Owned() : name_(Kind::make()) {}
  explicit Owned(GLuint name) : name_(name) {}
  Owned(Owned&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Owned() {
    if (name_ != 0) Kind::destroy(name_);
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

struct BufferKind {
  static GLuint make() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct VertexArrayKind {
  static GLuint make() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct TextureKind {
  static GLuint make() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct RenderbufferKind {
  static GLuint make() {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteRenderbuffers(1, &name); }
};
struct FramebufferKind {
  static GLuint make() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct ProgramKind {
  static GLuint make() { return glCreateProgram(); }
  static void destroy(GLuint name) { glDeleteProgram(name); }
};

using Buffer = Owned<BufferKind>;
using VertexArray = Owned<VertexArrayKind>;
using Texture = Owned<TextureKind>;
using Renderbuffer = Owned<RenderbufferKind>;
using Framebuffer = Owned<FramebufferKind>;

/// The text of a shader: functions, and what uses them.
using ShaderText = std::initializer_list<const char*>;

/// A vertex and a fragment shader at work together.
class Program {
 public:
  Program(ShaderText vertex, ShaderText fragment);

  void use() const { glUseProgram(program_.name()); }
  void set(const char* uniform, const Eigen::Matrix4f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, int value) const;

 private:
  GLint at(const char* uniform) const { return glGetUniformLocation(program_.name(), uniform); }
  Owned<ProgramKind> program_;
};

/// Fills a buffer of vertices or instances. `use`: GL_STATIC_DRAW or GL_STREAM_DRAW.
void fill(const Buffer&, GLenum target, const void* bytes, size_t size, GLenum use);
/// Attribute `slot` of the vertex array at hand: `width` floats at `offset` in records of `stride`
/// bytes; `instanced`: one record per instance.
void attribute(GLuint slot, const Buffer&, GLint width, size_t stride, size_t offset,
               bool instanced = false);
/// Throws when the framebuffer at hand cannot be drawn to.
void require_framebuffer(const char* what);

}  // namespace weft::render
