// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <utility>

#include <epoxy/gl.h>

#include "luxel/core/matrix.h"
#include "luxel/core/vector.h"

namespace luxel {

// Owns an OpenGL name and releases it at the end; one class per kind of object. The context in which it was
// made must be current then.
template <void (*give)(GLuint*), void (*take)(const GLuint*)>
class GlName {
 public:
  GlName() { give(&name_); }
  ~GlName() {
    if (name_ != 0) take(&name_);
  }
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

namespace gl {
inline void give_buffer(GLuint* n) { glGenBuffers(1, n); }
inline void take_buffer(const GLuint* n) { glDeleteBuffers(1, n); }
inline void give_array(GLuint* n) { glGenVertexArrays(1, n); }
inline void take_array(const GLuint* n) { glDeleteVertexArrays(1, n); }
inline void give_texture(GLuint* n) { glGenTextures(1, n); }
inline void take_texture(const GLuint* n) { glDeleteTextures(1, n); }
inline void give_render(GLuint* n) { glGenRenderbuffers(1, n); }
inline void take_render(const GLuint* n) { glDeleteRenderbuffers(1, n); }
inline void give_frame(GLuint* n) { glGenFramebuffers(1, n); }
inline void take_frame(const GLuint* n) { glDeleteFramebuffers(1, n); }
}  // namespace gl

using GlBuffer = GlName<gl::give_buffer, gl::take_buffer>;
using GlVertexArray = GlName<gl::give_array, gl::take_array>;
using GlTexture = GlName<gl::give_texture, gl::take_texture>;
using GlRenderbuffer = GlName<gl::give_render, gl::take_render>;
using GlFramebuffer = GlName<gl::give_frame, gl::take_frame>;

// A vertex and a fragment shader, and their uniforms by name.
class GlProgram {
 public:
  // The sources follow `#version 330 core` and the defines. Throws DeviceError with the driver's words where
  // they are refused.
  GlProgram(std::string_view vertex, std::string_view fragment, std::string_view defines = {});
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const { glUseProgram(name_); }
  // Sets uniforms of the program in use. A uniform that the driver removed as unused is ignored.
  void set(const char* uniform, float value) const;
  void set(const char* uniform, int value) const;
  void set(const char* uniform, int x, int y) const;
  void set(const char* uniform, const Vec3& value) const;
  void set(const char* uniform, const Vec2& value) const;
  void set(const char* uniform, const Mat4& value) const;
  void set(const char* uniform, const float* fours, int count) const;  // an array of vec4

 private:
  GLuint name_ = 0;
};

}  // namespace luxel
