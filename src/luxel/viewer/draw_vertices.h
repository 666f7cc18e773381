// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/surface/vertex_texture_ratios.h"

namespace luxel {

// A vertex on the graphics card: a smooth vertex with a material, as surface colours stay sharp where two
// materials share the light.
struct DrawVertex {
  std::uint32_t smooth = 0;
  std::uint32_t material = 0;
};

// Finds them patch by patch, so that a large mesh is spread over frames.
class DrawVertices {
 public:
  // Keeps references.
  DrawVertices(const PatchSet& patches, const SmoothLight& light);

  // Goes on with the next patches, at most `count`. About 30 ns per patch.
  void go_on(std::size_t count);
  bool is_done() const { return corners_.size() == patches_.size(); }

  const std::vector<DrawVertex>& vertices() const { return vertices_; }
  const std::vector<std::array<std::uint32_t, 3>>& corners() const { return corners_; }  // [patch]
  const VertexTextureRatios& ratios() const { return ratios_; }

 private:
  std::uint32_t vertex(std::uint32_t smooth, std::uint32_t material);

  const PatchSet& patches_;
  const SmoothLight& light_;
  std::vector<DrawVertex> vertices_;
  std::vector<std::array<std::uint32_t, 3>> corners_;
  std::vector<std::uint32_t> latest_;  // [smooth vertex]: the latest of its draw vertices
  VertexTextureRatios ratios_;
  std::vector<std::uint32_t> before_;  // [draw vertex]: the one of the same smooth vertex before it
};

// What a vertex shows.
enum class VertexValue {
  radiance,  // W/(m² sr), linear RGB
  lux,       // irradiance, in the first number
  watts      // irradiance over all bands, W/m², in the first number
};
struct TwoSides {
  Vec3 front, back;
};
TwoSides value_of(const DrawVertex& vertex, const TextureRatio& ratio, VertexValue what,
                  const PatchSet& patches, const BandColours& colours, const SmoothLight& light);

}  // namespace luxel
