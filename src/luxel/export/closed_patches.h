// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/surface/patch_cuts.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// A corner of what is drawn of a patch: one of the patch's corners, or a point on one of its edges.
struct DrawnPoint {
  std::uint32_t vertex = 0;  // index into PatchSet::vertices
  std::array<std::uint32_t, 2>
      smooth{};           // indices into SmoothLight: the ends of the edge; twice the same at a corner
  float fraction = 0.0f;  // of the way from the first to the second
  Vec3 weight{0.0f};      // of the patch's corners, sums to 1

  // Interpolates values at smooth vertices, `bands` numbers each.
  float at(std::span<const float> values, std::size_t band, std::size_t bands) const {
    const auto a = values[smooth[0] * bands + band];
    return fraction == 0.0f ? a : a + fraction * (values[smooth[1] * bands + band] - a);
  }
};

// Patches as triangles without T-junctions: where a vertex of other patches lies within an edge, the patch is
// divided there, and light is interpolated along the edge as before. Otherwise the rounding of a graphics
// card leaves cracks of single pixels along such edges, through which the background shows.
class ClosedPatches {
 public:
  // Keeps references. Cost: that of cut_at_hanging_vertices().
  ClosedPatches(const PatchSet& patches, const SmoothLight& light);

  // The triangles of a patch, as it is wound.
  std::vector<std::array<DrawnPoint, 3>> triangles(std::uint32_t patch) const;

 private:
  const PatchSet& patches_;
  const SmoothLight& light_;
  std::vector<PatchCut> cuts_;  // by patch
};

}  // namespace luxel
