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

MeshBuffers::MeshBuffers(const PatchSet& patches, const std::vector<PatchCut>& cuts)
    : patches_(patches), has_cuts_(!cuts.empty()) {
  if (has_cuts_) cut_ = drawn_triangles(patches, cuts);
  corners_.corners = has_cuts_ ? &cut_ : &patches.corners;
  if (has_cuts_) edges_.corners = &patches.corners;
}

MeshBuffers::MeshBuffers(const PatchSet& patches, const std::vector<PatchCut>& cuts, const SmoothLight& light)
    : patches_(patches), found_(std::in_place, patches, cuts, light), has_cuts_(!cuts.empty()) {
  corners_.corners = &found_->triangles();
  if (has_cuts_) edges_.corners = &found_->corners();
}

void MeshBuffers::Elements::allocate() {
  if (corners != nullptr)
    allocate_buffer<Corners::value_type>(GL_ELEMENT_ARRAY_BUFFER, buffer, corners->size());
}

void MeshBuffers::Elements::send() {
  const auto count = std::min(slice, corners->size() - sent);
  luxel::send(GL_ELEMENT_ARRAY_BUFFER, buffer, sent, corners->data() + sent, count);
  sent += count;
}

void MeshBuffers::Elements::draw() const {
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * sent), GL_UNSIGNED_INT, nullptr);
}

void MeshBuffers::allocate() {
  glBindVertexArray(array_.name());
  allocate_buffer<Vec3>(GL_ARRAY_BUFFER, places_, vertex_count());
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3), nullptr);
  glEnableVertexAttribArray(0);
  corners_.allocate();
  edges_.allocate();
  is_allocated_ = true;
}

bool MeshBuffers::go_on() {
  if (is_done()) return false;
  if (found_ && !found_->is_done()) {
    found_->go_on(slice);
    return true;
  }
  if (!is_allocated_) allocate();
  glBindVertexArray(array_.name());  // binds this mesh's element array, not another's
  if (sent_ < vertex_count()) {
    send_places();
  } else {
    corners_.is_done() ? edges_.send() : corners_.send();
  }
  return true;
}

void MeshBuffers::send_places() {
  const auto count = std::min(slice, vertex_count() - sent_);
  if (!found_) {
    send(GL_ARRAY_BUFFER, places_, sent_, patches_.vertices.data() + sent_, count);
  } else {
    std::vector<Vec3> places(count);
    for (std::size_t i = 0; i < count; ++i) places[i] = found_->place(found_->vertices()[sent_ + i]);
    send(GL_ARRAY_BUFFER, places_, sent_, places.data(), count);
  }
  sent_ += count;
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
  if (corners_.sent == 0) return;
  glBindVertexArray(array_.name());
  corners_.draw();
}

void MeshBuffers::draw_patches() const {
  if (!has_cuts_) return draw();
  if (edges_.sent == 0) return;
  glBindVertexArray(array_.name());
  edges_.draw();
}

ValueBuffer::ValueBuffer(const PatchSet& patches, const SmoothLight& light, VertexValue what,
                         const DrawVertices& vertices)
    : patches_(patches), light_(light), what_(what), vertices_(vertices), colours_(patches.colours()) {
  allocate_buffer<TwoSides>(GL_ARRAY_BUFFER, buffer_, vertices.vertices().size());
}

TwoSides ValueBuffer::value(std::size_t i) const {
  const auto& vertex = vertices_.vertices()[i];
  if (!vertex.is_on_edge())
    return value_of(vertex, vertices_.ratios().at(i), what_, patches_, colours_, light_);
  const auto from = value(vertex.from), to = value(vertex.to);
  return {glm::mix(from.front, to.front, vertex.fraction), glm::mix(from.back, to.back, vertex.fraction)};
}

bool ValueBuffer::go_on() {
  const auto count =
      std::min(slice / 4, vertices_.vertices().size() - sent_);  // each vertex needs some arithmetic
  if (count == 0) return false;
  std::vector<TwoSides> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = value(sent_ + i);
  send(GL_ARRAY_BUFFER, buffer_, sent_, values.data(), count);
  sent_ += count;
  return true;
}

SideTexture::SideTexture(const PatchSet& patches, const std::vector<PatchCut>& cuts,
                         const std::vector<float>& values) {
  if (cuts.empty()) {
    values_ = values;
  } else {
    for (const auto patch : patches_of_triangles(patches, cuts))
      values_.insert(values_.end(), {values[2 * patch], values[2 * patch + 1]});
  }
  rows_ = (values_.size() / 2 + width - 1) / width;
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
