// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/lines.h"

#include <string_view>

#include "luxel/viewer/gl_object.h"

namespace luxel {
namespace {

constexpr std::string_view vertex_shader = R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 colour;
uniform mat4 projection;
out vec3 ink;
void main() {
  gl_Position = projection * vec4(place, 1.0);
  gl_Position.z -= 1e-4 * gl_Position.w;  // before the surface it lies on
  ink = colour;
}
)";
constexpr std::string_view fragment_shader = R"(
in vec3 ink;
uniform float strength;
out vec4 pixel;
void main() { pixel = vec4(ink, strength); }
)";

}  // namespace

void Marks::add_box(const Bounds& box, const Vec3& colour) {
  const auto corner = [&](int i) {
    return Vec3(i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                i & 4 ? box.high.z : box.low.z);
  };
  for (int i = 0; i < 8; ++i)
    for (const int axis : {1, 2, 4})
      if ((i & axis) == 0) add_segment(corner(i), corner(i | axis), colour);
}

struct MarkBuffer::State {
  GlVertexArray array;
  GlBuffer buffer;
  GLsizei segments = 0, points = 0;
  GlProgram program{vertex_shader, fragment_shader};

  void draw() const {
    if (segments > 0) glDrawArrays(GL_LINES, 0, segments);
    if (points > 0) glDrawArrays(GL_POINTS, segments, points);
  }
};

MarkBuffer::MarkBuffer() : state_(std::make_unique<State>()) {
  glBindVertexArray(state_->array.name());
  glBindBuffer(GL_ARRAY_BUFFER, state_->buffer.name());
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Marks::Mark), nullptr);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Marks::Mark),
                        reinterpret_cast<const void*>(sizeof(Vec3)));
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);
}
MarkBuffer::~MarkBuffer() = default;

void MarkBuffer::set(const Marks& marks) {
  state_->segments = static_cast<GLsizei>(marks.segments.size());
  state_->points = static_cast<GLsizei>(marks.points.size());
  const auto bytes = [](const auto& some) {
    return static_cast<GLsizeiptr>(some.size() * sizeof(Marks::Mark));
  };
  glBindBuffer(GL_ARRAY_BUFFER, state_->buffer.name());
  glBufferData(GL_ARRAY_BUFFER, bytes(marks.segments) + bytes(marks.points), nullptr, GL_DYNAMIC_DRAW);
  glBufferSubData(GL_ARRAY_BUFFER, 0, bytes(marks.segments), marks.segments.data());
  glBufferSubData(GL_ARRAY_BUFFER, bytes(marks.segments), bytes(marks.points), marks.points.data());
}

void MarkBuffer::draw(const Mat4& projection, float point_size, bool through) const {
  const auto& s = *state_;
  if (s.segments + s.points == 0) return;
  s.program.use();
  s.program.set("projection", projection);
  glBindVertexArray(s.array.name());
  glEnable(GL_DEPTH_TEST);
  glPointSize(point_size);
  if (through) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GREATER);
    s.program.set("strength", 0.25f);
    s.draw();
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
  }
  glDepthFunc(GL_LEQUAL);
  s.program.set("strength", 1.0f);
  s.draw();
}

}  // namespace luxel
