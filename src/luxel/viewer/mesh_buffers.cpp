// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/mesh_buffers.h"

#include <algorithm>

namespace luxel {
namespace {

template <typename T>
void allocate_buffer(GLenum target, const GlBuffer& buffer, std::size_t count) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(count * sizeof(T)), nullptr, GL_STATIC_DRAW);
}

template <typename T>
void send(GLenum target, const GlBuffer& buffer, std::size_t first, const T* values, std::size_t count) {
  glBindBuffer(target, buffer.name());
  glBufferSubData(target, static_cast<GLintptr>(first * sizeof(T)),
                  static_cast<GLsizeiptr>(count * sizeof(T)), values);
}

}  // namespace

MeshBuffers::MeshBuffers(const PatchSet& patches) : patches_(patches) {}

MeshBuffers::MeshBuffers(const PatchSet& patches, const SmoothLight& light)
    : patches_(patches), light_(&light), found_(std::in_place, patches, light) {}

void MeshBuffers::allocate() {
  glBindVertexArray(array_.name());
  allocate_buffer<Vec3>(GL_ARRAY_BUFFER, places_, vertex_count());
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3), nullptr);
  glEnableVertexAttribArray(0);
  allocate_buffer<std::array<std::uint32_t, 3>>(GL_ELEMENT_ARRAY_BUFFER, corners_, patches_.size());
  is_allocated_ = true;
}

bool MeshBuffers::go_on() {
  if (is_done()) return false;
  if (found_ && !found_->is_done()) {
    found_->go_on(slice);
    return true;
  }
  if (!is_allocated_) allocate();
  if (sent_ < vertex_count()) {
    send_places();
  } else {
    send_triangles();
  }
  return true;
}

void MeshBuffers::send_places() {
  const auto count = std::min(slice, vertex_count() - sent_);
  if (!found_) {
    send(GL_ARRAY_BUFFER, places_, sent_, patches_.vertices.data() + sent_, count);
  } else {
    std::vector<Vec3> places(count);
    for (std::size_t i = 0; i < count; ++i)
      places[i] = patches_.vertices[light_->vertex[found_->vertices()[sent_ + i].smooth]];
    send(GL_ARRAY_BUFFER, places_, sent_, places.data(), count);
  }
  sent_ += count;
}

void MeshBuffers::send_triangles() {
  const auto& corners = found_ ? found_->corners() : patches_.corners;
  const auto count = std::min(slice, corners.size() - triangles_);
  glBindVertexArray(array_.name());  // its triangles must be meant, not another's
  send(GL_ELEMENT_ARRAY_BUFFER, corners_, triangles_, corners.data() + triangles_, count);
  triangles_ += count;
}

void MeshBuffers::take_values(const GlBuffer& values) const {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, values.name());
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(TwoSides), nullptr);
  glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, sizeof(TwoSides),
                        reinterpret_cast<const void*>(sizeof(Vec3)));
  glEnableVertexAttribArray(1);
  glEnableVertexAttribArray(2);
}

void MeshBuffers::draw() const {
  if (triangles_ == 0) return;
  glBindVertexArray(array_.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * triangles_), GL_UNSIGNED_INT, nullptr);
}

ValueBuffer::ValueBuffer(const PatchSet& patches, const SmoothLight& light, VertexValue what,
                         const DrawVertices& vertices)
    : patches_(patches), light_(light), what_(what), vertices_(vertices), colours_(patches.colours()) {
  allocate_buffer<TwoSides>(GL_ARRAY_BUFFER, buffer_, vertices.vertices().size());
}

bool ValueBuffer::go_on() {
  const auto count =
      std::min(slice / 4, vertices_.vertices().size() - sent_);  // each is worth some arithmetic
  if (count == 0) return false;
  std::vector<TwoSides> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = value_of(vertices_.vertices()[sent_ + i], vertices_.ratios().at(sent_ + i), what_, patches_,
                         colours_, light_);
  send(GL_ARRAY_BUFFER, buffer_, sent_, values.data(), count);
  sent_ += count;
  return true;
}

SideTexture::SideTexture(const std::vector<float>& values)
    : values_(values), rows_((values.size() / 2 + width - 1) / width) {
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, width, static_cast<GLsizei>(rows_), 0, GL_RG, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

bool SideTexture::go_on() {
  const auto rows = std::min(slice / width, rows_ - sent_);
  if (rows == 0) return false;
  const auto first = 2 * width * sent_, wanted = 2 * width * rows;
  std::vector<float> some(wanted, 0.0f);  // the last row is seldom full
  std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(first), std::min(wanted, values_.size() - first),
              some.begin());
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(sent_), width, static_cast<GLsizei>(rows), GL_RG,
                  GL_FLOAT, some.data());
  sent_ += rows;
  return true;
}

}  // namespace luxel
