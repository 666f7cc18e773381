// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/image/tone.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// A corner of a patch: 3 * patch + its number there, 0 to 2.
using CornerId = std::uint32_t;

// What a display shows at the corners of patches, and how much of a difference counts.
class DisplayedCorners {
 public:
  // max_error: see SimplifyOptions. Textures do not count.
  DisplayedCorners(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
                   const ToneCurve& curve, float max_error);

  // The error at a corner of what is interpolated between three others: 1 where it is the largest allowed.
  // Weights sum to one. Of the back too where light falls on any.
  float error(CornerId at, const std::array<CornerId, 3>& others, const Vec3& weights) const;

 private:
  // Of one side of a smooth vertex with one material.
  struct Look {
    Vec3 colour{0.0f};           // linear, as displayed
    Vec3 colour_scale{0.0f};     // 1 / the largest error allowed
    float irradiance = 0.0f;     // sum over bands, W/m²
    float irradiance_scale = 0;  // 1 / the largest error allowed
  };
  static float error(const Look& at, const std::array<const Look*, 3>& others, const Vec3& weights);

  std::vector<std::uint32_t> look_;  // [corner]
  std::vector<Look> front_, back_;   // [look]
  bool has_backs_ = false;
};

}  // namespace luxel
