// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
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

// Patches, vertices or values that are sent to the card per step: well under a millisecond.
inline constexpr std::size_t slice = 16'384;

// Vertices and triangles on the card, without T-junctions. Each go_on() sends a slice; false where nothing
// was left to do. Keeps references.
class MeshBuffers {
 public:
  // Vertices of the patches; triangles can be drawn as they arrive.
  MeshBuffers(const PatchSet& patches, const std::vector<PatchCut>& cuts);
  // Vertices of DrawVertices, for values.
  MeshBuffers(const PatchSet& patches, const std::vector<PatchCut>& cuts, const SmoothLight& light);

  MeshBuffers(const MeshBuffers&) = delete;
  MeshBuffers& operator=(const MeshBuffers&) = delete;

  bool go_on();
  bool is_done() const { return is_allocated_ && corners_.is_done() && edges_.is_done(); }
  // Draw vertices of a completed mesh for values.
  const DrawVertices& vertices() const { return *found_; }

  // values: two vec3 per vertex.
  void take_values(const GlBuffer& values) const;
  void draw() const;
  // Draws the patches, whose edges differ from those of the triangles where patches are cut.
  void draw_patches() const;

 private:
  using Corners = std::vector<std::array<std::uint32_t, 3>>;
  // Triangles on their way to the card.
  struct Elements {
    GlBuffer buffer = {};
    const Corners* corners = nullptr;  // null: none
    std::size_t sent = 0;

    bool is_done() const { return corners == nullptr || sent == corners->size(); }
    void allocate();
    void send();
    void draw() const;
  };
  void allocate();
  std::size_t vertex_count() const { return found_ ? found_->vertices().size() : patches_.vertices.size(); }
  void send_places();

  const PatchSet& patches_;
  std::optional<DrawVertices> found_;
  Corners cut_;  // of patches without light, where some are cut
  GlVertexArray array_;
  GlBuffer places_;
  Elements corners_, edges_;  // triangles; the patches, where these are others
  bool has_cuts_, is_allocated_ = false;
  std::size_t sent_ = 0;  // vertices
};

// Values of the vertices of a mesh, two vec3 each.
class ValueBuffer {
 public:
  ValueBuffer(const PatchSet& patches, const SmoothLight& light, VertexValue what,
              const DrawVertices& vertices);
  bool go_on();
  const GlBuffer& buffer() const { return buffer_; }

 private:
  TwoSides value(std::size_t vertex) const;

  const PatchSet& patches_;
  const SmoothLight& light_;
  VertexValue what_;
  const DrawVertices& vertices_;
  BandColours colours_;
  GlBuffer buffer_;
  std::size_t sent_ = 0;
};

// One value per side of a triangle that is drawn, as a texture.
class SideTexture {
 public:
  // values: [2 * patch + 1 for the back]. Keeps no reference.
  SideTexture(const PatchSet& patches, const std::vector<PatchCut>& cuts, const std::vector<float>& values);
  bool go_on();
  const GlTexture& texture() const { return texture_; }

 private:
  static constexpr std::size_t width = 1024;  // triangles per row; every card takes that
  std::vector<float> values_;
  GlTexture texture_;
  std::size_t rows_ = 0, sent_ = 0;
};

}  // namespace luxel
