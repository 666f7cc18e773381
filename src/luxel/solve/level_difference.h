// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

// The light of a mesh as solved, and as reconstructed from that.
struct Answer {
  Solution solution;
  SmoothLight smooth;
};
// Two independent estimates: the squares of either contain its noise, their products do not.
using Answers = std::array<Answer, 2>;

// The mean of both, with its errors.
Solution mean_of(const Answers& answers);

// Squared differences of irradiance per side and band, in the mean over the patch: [patch][band], (W/m²)². On
// a face of a curved surface (curved_faces.h) from the field or, where that is smaller, within the face.
struct FieldDifference {
  FrontAndBack<double> squared;  // the product of both answers' differences: unbiased, so below 0 in places
  FrontAndBack<double> noise;    // of the mean of both, in squares: from how they differ from each other
};

// Contributions of patches to a squared error, and to the square of its noise: [patch].
struct Contributions {
  std::vector<double> squared, noise;
};
// Sums over sides and bands. weights: [side], squared error per squared difference.
Contributions weighed(const FieldDifference& difference, std::span<const double> weights, std::size_t bands);

// Squared difference of the light of parts from the light reconstructed on the wholes.
FieldDifference difference_of_levels(const PatchSet& wholes, const Answers& coarse, const PatchSet& parts,
                                     const Answers& fine, std::span<const std::uint32_t> parent,
                                     const Context& context);

// Squared variation of light within patches that their means do not show: differences of parts from the light
// reconstructed on the whole, less the mean of these differences over the whole. [patch of wholes][band]; 0
// where a patch was not cut.
FieldDifference variation_within_wholes(const PatchSet& wholes, const Answers& coarse, const PatchSet& parts,
                                        const Answers& fine, std::span<const std::uint32_t> parent,
                                        const Context& context);

// The squared residual of the reconstruction: the mean over a patch against that of the field reconstructed
// on it, 0 where light is linear. The estimate where nothing was cut: the same order as the error of the
// field where light bends or jumps from patch to patch.
FieldDifference residual_within_patches(const PatchSet& patches, const Answers& answers,
                                        const Context& context);

// The light of wholes: the area-weighted mean of that of their parts, as if it had been solved on them.
// Irradiance alone. parent: [part].
Solution light_of_wholes(const PatchSet& wholes, const PatchSet& parts, const Solution& light,
                         std::span<const std::uint32_t> parent);

// Sum over sides and bands of area times squared irradiance, without the noise.
double squared_light(const PatchSet& patches, const Answers& answers);

}  // namespace luxel
