#include "render/gl.h"

#include "io/error.h"

#include <string>
#include <vector>

namespace weft::render {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw io::UnavailableError("pictures cannot be made (" + what +
                             ") use another OpenGL driver, or write obj, ply or pc2");
}

void attach(GLuint program, GLenum kind, ShaderText text) {
  const GLuint shader = glCreateShader(kind);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // when it is attached to nothing
  std::vector<const char*> parts{"#version 330 core\n"};
  parts.insert(parts.end(), text);
  glShaderSource(shader, GLsizei(parts.size()), parts.data(), nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return;
  char log[1000] = {};
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  fail(std::string("the driver refuses a shader: ") + log);
}

}  // namespace

Program::Program(ShaderText vertex, ShaderText fragment) : name_(glCreateProgram()) {
  attach(name_, GL_VERTEX_SHADER, vertex);
  attach(name_, GL_FRAGMENT_SHADER, fragment);
  glLinkProgram(name_);
  GLint good = 0;
  glGetProgramiv(name_, GL_LINK_STATUS, &good);
  if (good) return;
  char log[1000] = {};
  glGetProgramInfoLog(name_, sizeof log, nullptr, log);
  fail(std::string("the driver cannot link two shaders: ") + log);
}

void Program::set(const char* uniform, const Eigen::Matrix4f& value) const {
  glUniformMatrix4fv(at(uniform), 1, GL_FALSE, value.data());
}
void Program::set(const char* uniform, const Eigen::Vector3f& value) const {
  glUniform3fv(at(uniform), 1, value.data());
}
void Program::set(const char* uniform, float value) const { glUniform1f(at(uniform), value); }

void fill(const Buffer& buffer, GLenum target, const void* bytes, size_t size, GLenum use) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, GLsizeiptr(size), bytes, use);
}

void attribute(GLuint slot, const Buffer& buffer, GLint width, size_t stride, size_t offset,
               bool instanced) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glVertexAttribPointer(slot, width, GL_FLOAT, GL_FALSE, GLsizei(stride),
                        reinterpret_cast<const void*>(offset));
  glEnableVertexAttribArray(slot);
  glVertexAttribDivisor(slot, instanced ? 1 : 0);
}

void require_framebuffer(const char* what) {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
  fail(std::string("the driver cannot draw to ") + what);
}

}  // namespace weft::render
