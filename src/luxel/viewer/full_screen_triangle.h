// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "luxel/viewer/gl_object.h"

namespace luxel {

// Internal to this module. A triangle over the whole viewport, so that a program runs at every pixel.
class FullScreenTriangle {
 public:
  static constexpr std::string_view vertex_shader = R"(
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";
  // Draws with the current program.
  void draw() const {
    glBindVertexArray(nothing_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

 private:
  GlVertexArray nothing_;
};

}  // namespace luxel
