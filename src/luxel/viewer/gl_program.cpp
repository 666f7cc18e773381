// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/viewer/gl_object.h"

namespace luxel {
namespace {

GLuint compile(GLenum kind, std::string_view source, std::string_view defines) {
  const auto text = fmt::format("#version 330 core\n{}\n#line 1\n{}", defines, source);
  const auto shader = glCreateShader(kind);
  const char* begin = text.c_str();
  glShaderSource(shader, 1, &begin, nullptr);
  glCompileShader(shader);
  GLint is_fine = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &is_fine);
  if (is_fine == GL_TRUE) return shader;
  char said[2000] = "";
  glGetShaderInfoLog(shader, sizeof said, nullptr, said);
  glDeleteShader(shader);
  throw DeviceError(fmt::format("the graphics driver refuses a shader: {}", said));
}

}  // namespace

GlProgram::GlProgram(std::string_view vertex, std::string_view fragment, std::string_view defines) {
  const auto v = compile(GL_VERTEX_SHADER, vertex, defines);
  const auto f = compile(GL_FRAGMENT_SHADER, fragment, defines);
  name_ = glCreateProgram();
  glAttachShader(name_, v);
  glAttachShader(name_, f);
  glLinkProgram(name_);
  glDeleteShader(v);
  glDeleteShader(f);
  GLint is_fine = GL_FALSE;
  glGetProgramiv(name_, GL_LINK_STATUS, &is_fine);
  if (is_fine == GL_TRUE) return;
  char said[2000] = "";
  glGetProgramInfoLog(name_, sizeof said, nullptr, said);
  glDeleteProgram(name_);
  throw DeviceError(fmt::format("the graphics driver refuses to link a program: {}", said));
}

GlProgram::~GlProgram() { glDeleteProgram(name_); }

void GlProgram::set(const char* uniform, float value) const {
  glUniform1f(glGetUniformLocation(name_, uniform), value);
}
void GlProgram::set(const char* uniform, int value) const {
  glUniform1i(glGetUniformLocation(name_, uniform), value);
}
void GlProgram::set(const char* uniform, int x, int y) const {
  glUniform2i(glGetUniformLocation(name_, uniform), x, y);
}
void GlProgram::set(const char* uniform, const Vec3& value) const {
  glUniform3f(glGetUniformLocation(name_, uniform), value.x, value.y, value.z);
}
void GlProgram::set(const char* uniform, const Vec2& value) const {
  glUniform2f(glGetUniformLocation(name_, uniform), value.x, value.y);
}
void GlProgram::set(const char* uniform, const Mat4& value) const {
  glUniformMatrix4fv(glGetUniformLocation(name_, uniform), 1, GL_FALSE, &value[0][0]);
}
void GlProgram::set(const char* uniform, const float* fours, int count) const {
  glUniform4fv(glGetUniformLocation(name_, uniform), count, fours);
}

}  // namespace luxel
