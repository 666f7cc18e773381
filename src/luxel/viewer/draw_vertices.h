// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/patch_cuts.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/surface/vertex_texture_ratios.h"

namespace luxel {

// A vertex on the graphics card: a smooth vertex with a material, so that colours stay sharp between two
// materials of equal light. Or a vertex within an edge of a patch, with interpolated values.
struct DrawVertex {
  std::uint32_t smooth = 0;
  std::uint32_t material = 0;
  // Within an edge: the draw vertices at its ends, both earlier ones, and its fraction of the way.
  std::uint32_t from = none, to = none;
  float fraction = 0.0f;
  std::uint32_t vertex = none;  // within an edge: index into PatchSet::vertices

  bool is_on_edge() const { return from != none; }
};

// Finds draw vertices patch by patch, so that a large mesh is spread over frames, and the drawn triangles:
// patches, cut where vertices of others lie on their edges (PatchCut).
class DrawVertices {
 public:
  // Keeps references.
  DrawVertices(const PatchSet& patches, const std::vector<PatchCut>& cuts, const SmoothLight& light);

  // Processes the next patches, at most `count`. About 30 ns per patch.
  void go_on(std::size_t count);
  bool is_done() const { return corners_.size() == patches_.size(); }

  const std::vector<DrawVertex>& vertices() const { return vertices_; }
  const std::vector<std::array<std::uint32_t, 3>>& corners() const { return corners_; }  // [patch]
  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }
  const VertexTextureRatios& ratios() const { return ratios_; }
  Vec3 place(const DrawVertex& vertex) const {  // m
    return patches_.vertices[vertex.is_on_edge() ? vertex.vertex : light_.vertex[vertex.smooth]];
  }

 private:
  std::uint32_t vertex(std::uint32_t smooth, std::uint32_t material);
  std::uint32_t add(const DrawVertex& vertex);
  void cut(const PatchCut& cut);

  const PatchSet& patches_;
  const std::vector<PatchCut>& cuts_;
  const SmoothLight& light_;
  std::size_t next_cut_ = 0;
  std::vector<DrawVertex> vertices_;
  std::vector<std::array<std::uint32_t, 3>> corners_, triangles_;
  std::vector<std::uint32_t> latest_;  // [smooth vertex]: the latest of its draw vertices
  VertexTextureRatios ratios_;
  std::vector<std::uint32_t> before_;  // [draw vertex]: the one of the same smooth vertex before it
};

// The triangles that are drawn of patches without light, as indices into PatchSet::vertices: in the order of
// DrawVertices::triangles().
std::vector<std::array<std::uint32_t, 3>> drawn_triangles(const PatchSet& patches,
                                                          const std::vector<PatchCut>& cuts);
// The patch of each triangle that is drawn.
std::vector<std::uint32_t> patches_of_triangles(const PatchSet& patches, const std::vector<PatchCut>& cuts);

// Value that a vertex shows.
enum class VertexValue {
  radiance,  // W/(m² sr), linear RGB
  lux,       // irradiance, in the first number
  watts      // irradiance over all bands, W/m², in the first number
};
struct TwoSides {
  Vec3 front, back;
};
// Value of a vertex that is not within an edge.
TwoSides value_of(const DrawVertex& vertex, const TextureRatio& ratio, VertexValue what,
                  const PatchSet& patches, const BandColours& colours, const SmoothLight& light);

}  // namespace luxel
