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

// Displayed colours at the corners of patches, and the differences that are allowed.
class DisplayedCorners {
 public:
  // max_error, hidden: see SimplifyOptions. Textures do not count.
  DisplayedCorners(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
                   const ToneCurve& curve, float max_error, const FrontAndBack<std::uint8_t>& hidden);

  // Error at a corner of the interpolation between three others; 1: the largest allowed. Weights sum to one.
  // Includes backs if light falls on any back. A side of a vertex that is hidden in all patches there has no
  // error.
  float error(CornerId at, const std::array<CornerId, 3>& others, const Vec3& weights) const;
  // The same at the middle between two corners, where the light is the mean of theirs.
  float middle_error(CornerId a, CornerId b, const std::array<CornerId, 3>& others,
                     const Vec3& weights) const;

 private:
  // Display of one side of a smooth vertex with one material.
  struct Look {
    Vec3 colour{0.0f};           // linear, as displayed
    Vec3 colour_scale{0.0f};     // 1 / the largest error allowed
    float irradiance = 0.0f;     // sum over bands, W/m²
    float irradiance_scale = 0;  // 1 / the largest error allowed
  };
  static Look middle(const Look& a, const Look& b);
  template <typename At>  // Look of a side's looks
  float error_of_sides(const At& at, const std::array<CornerId, 3>& others, const Vec3& weights) const;
  static float error(const Look& at, const std::array<const Look*, 3>& others, const Vec3& weights);

  std::vector<std::uint32_t> look_;  // [corner]
  std::vector<Look> front_, back_;   // [look]
  bool has_backs_ = false;
};

}  // namespace luxel
