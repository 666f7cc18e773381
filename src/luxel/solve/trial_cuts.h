// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solve/level_difference.h"
#include "luxel/solve/sampled.h"

namespace luxel {

// Finds patches whose light varies within them as no mean of a patch shows: something that hangs close before
// a large patch has a shadow smaller than the patch. Patches are cut on trial, their parts gather rays of the
// known light for both answers (solve/part_light.h), and the cuts are discarded. What a cut would change
// within the patch is the product of both answers' differences between the parts' means and the light
// reconstructed on the whole (variation_within_wholes()), in which noise cancels. Patches where it exceeds
// the noise are tried again by four times as many other rays; these alone decide, so that their estimate does
// not contain the noise of rays that selected them.
//
// Rays are in proportion to what a patch contributes to what is seen: that many tell whether its variation
// exceeds one and the same error. One object follows a mesh from cut to cut.
class TrialCuts {
 public:
  // density: [patch], 1/m², see seen_densities(). Errors count by their square in the mean view, relative to
  // the light there. Empty: by that of the power.
  TrialCuts(std::size_t patches, std::vector<double> density);

  // Tries patches that were not tried before. max_rays: of the first time; the second takes at most four
  // times as many. how: options of the rays; equal seeds give equal rays. Returns the number of rays; nothing
  // if the monitor stops the work. Cost beside the rays: twice that of refine_patches(), of a tracer and of
  // two patch trees. The same bits on any number of threads and processes.
  std::optional<std::uint64_t> try_out(const PatchSet& patches, const Answers& answers, double max_rays,
                                       const SampledOptions& how, const Context& context);

  // Follows the patches into a mesh where some were cut. parent: [part].
  void note_cut(std::span<const std::uint32_t> parent);

  // [patch]: contribution to the squared error where it surely is above 0, else 0.
  std::span<const double> squared() const { return squared_; }

 private:
  std::vector<double> density_;
  std::vector<std::uint8_t> is_candidate_;  // [patch]: was not tried
  std::vector<double> squared_;
  double rays_per_contribution_ = 0.0;  // of a part, at most; 0: no limit
};

}  // namespace luxel
