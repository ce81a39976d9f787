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

/// Lives until its program is linked.
class Shader {
 public:
  Shader(GLenum kind, ShaderText text) : name_(glCreateShader(kind)) {
    std::vector<const char*> parts{"#version 330 core\n"};
    parts.insert(parts.end(), text);
    glShaderSource(name_, GLsizei(parts.size()), parts.data(), nullptr);
    glCompileShader(name_);
    GLint good = 0;
    glGetShaderiv(name_, GL_COMPILE_STATUS, &good);
    if (!good) {
      char log[1000] = {};
      glGetShaderInfoLog(name_, sizeof log, nullptr, log);
      fail(std::string("the driver refuses a shader: ") + log);
    }
  }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  ~Shader() { glDeleteShader(name_); }
  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

}  // namespace

Program::Program(ShaderText vertex, ShaderText fragment) : name_(glCreateProgram()) {
  const Shader vertices(GL_VERTEX_SHADER, vertex), fragments(GL_FRAGMENT_SHADER, fragment);
  glAttachShader(name_, vertices.name());
  glAttachShader(name_, fragments.name());
  glLinkProgram(name_);
  GLint good = 0;
  glGetProgramiv(name_, GL_LINK_STATUS, &good);
  if (!good) {
    char log[1000] = {};
    glGetProgramInfoLog(name_, sizeof log, nullptr, log);
    fail(std::string("the driver cannot link two shaders: ") + log);
  }
}

void Program::set(const char* uniform, const Eigen::Matrix4f& value) const {
  glUniformMatrix4fv(at(uniform), 1, GL_FALSE, value.data());
}
void Program::set(const char* uniform, const Eigen::Vector3f& value) const {
  glUniform3fv(at(uniform), 1, value.data());
}
void Program::set(const char* uniform, float value) const { glUniform1f(at(uniform), value); }
void Program::set(const char* uniform, int value) const { glUniform1i(at(uniform), value); }

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
