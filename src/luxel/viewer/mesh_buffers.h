// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/viewer/draw_vertices.h"
#include "luxel/viewer/gl_object.h"

namespace luxel {

// How many patches, vertices or values go to the card in one step: well under a millisecond.
inline constexpr std::size_t slice = 16'384;

// Vertices and triangles on the card. Each go_on() is a slice; false where nothing was left to do.
class MeshBuffers {
 public:
  // As the patches have them; triangles are there to be drawn as they come.
  explicit MeshBuffers(const PatchSet& patches);
  // With a vertex for each that DrawVertices finds, for values.
  MeshBuffers(const PatchSet& patches, const SmoothLight& light);

  bool go_on();
  bool is_done() const { return triangles_ == patches_.size(); }
  // Of a mesh for values, when it is done.
  const DrawVertices& vertices() const { return *found_; }

  // values: two vec3 a vertex.
  void take_values(const GlBuffer& values) const;
  void draw() const;

 private:
  void allocate();
  std::size_t vertex_count() const { return found_ ? found_->vertices().size() : patches_.vertices.size(); }
  void send_places();
  void send_triangles();

  const PatchSet& patches_;
  const SmoothLight* light_ = nullptr;
  std::optional<DrawVertices> found_;
  GlVertexArray array_;
  GlBuffer places_, corners_;
  bool is_allocated_ = false;
  std::size_t sent_ = 0, triangles_ = 0;  // vertices, triangles
};

// Values of the vertices of a mesh, two vec3 each.
class ValueBuffer {
 public:
  ValueBuffer(const PatchSet& patches, const SmoothLight& light, VertexValue what,
              const DrawVertices& vertices);
  bool go_on();
  const GlBuffer& buffer() const { return buffer_; }

 private:
  const PatchSet& patches_;
  const SmoothLight& light_;
  VertexValue what_;
  const DrawVertices& vertices_;
  BandColours colours_;
  GlBuffer buffer_;
  std::size_t sent_ = 0;
};

// One value a patch side, as a texture.
class SideTexture {
 public:
  explicit SideTexture(const std::vector<float>& values);
  bool go_on();
  const GlTexture& texture() const { return texture_; }

 private:
  static constexpr std::size_t width = 1024;  // patches per row; every card takes that
  const std::vector<float>& values_;
  GlTexture texture_;
  std::size_t rows_ = 0, sent_ = 0;
};

}  // namespace luxel
