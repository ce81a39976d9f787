// Owners of OpenGL objects, and the few calls that need more than one line.
#pragma once

#include <epoxy/gl.h>

#include <Eigen/Core>

#include <cstddef>
#include <initializer_list>
#include <utility>

namespace weft::render {

/// Deletes its object in the end. The parameters are two of OpenGL's functions.
template <PFNGLGENTEXTURESPROC& Make, PFNGLDELETETEXTURESPROC& Delete>
class Owned {
 public:
  Owned() { Make(1, &name_); }
  Owned(Owned&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Owned() { Delete(1, &name_); }  // of 0: nothing
  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

using Buffer = Owned<glGenBuffers, glDeleteBuffers>;
using VertexArray = Owned<glGenVertexArrays, glDeleteVertexArrays>;
using Texture = Owned<glGenTextures, glDeleteTextures>;
using Renderbuffer = Owned<glGenRenderbuffers, glDeleteRenderbuffers>;
using Framebuffer = Owned<glGenFramebuffers, glDeleteFramebuffers>;

/// The text of a shader: functions, and what uses them.
using ShaderText = std::initializer_list<const char*>;

/// A vertex and a fragment shader at work together.
class Program {
 public:
  Program(ShaderText vertex, ShaderText fragment);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() { glDeleteProgram(name_); }

  void use() const { glUseProgram(name_); }
  void set(const char* uniform, const Eigen::Matrix4f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, float value) const;

 private:
  GLint at(const char* uniform) const { return glGetUniformLocation(name_, uniform); }
  GLuint name_;
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
