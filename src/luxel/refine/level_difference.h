// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/parallel/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// A mesh, its light as solved, and as reconstructed from that.
struct LevelLight {
  const PatchSet& patches;
  const Solution& solution;
  const SmoothLight& smooth;
};

// What patches say of a field that stands for the light. Arrays are [patch]: squared differences of
// irradiance, summed over sides and bands, times area: (W/m²)² m².
struct FieldDifference {
  std::vector<double> squared;  // less what noise makes of it, so below 0 in places; its sum is unbiased
  std::vector<double> noise;    // what was taken off
};

// How far the light of patches lies from the light reconstructed on the coarser ones that they are parts of.
// Where both are noisy, the noise is taken off as the standard errors state it. parent: [fine patch].
FieldDifference difference_of_levels(const LevelLight& coarse, const LevelLight& fine,
                                     std::span<const std::uint32_t> parent, const Workers& workers);

// How far the reconstructed light of patches lies from the one value that each has: its variance over the
// patch. All there is to go by where there is but one mesh; it says more than is wrong.
FieldDifference difference_within_patches(const LevelLight& level, const Workers& workers);

// Sum over sides and bands of area times squared irradiance.
double squared_light(const PatchSet& patches, const Solution& solution);

}  // namespace luxel
