// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solve/sampled.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

struct RefineOptions {
  /// Patches to begin with, if no edge was given: enough to see where to look.
  static constexpr std::size_t coarse_patches = 800;
  /// Target: the error that the size of patches leaves in the reconstructed light, in the measure of
  /// light.error_measure.
  double mesh_error = 0.02;
  std::size_t max_patches = 1'000'000;
  int max_levels = 12;
  /// Rays of the refinement over those of a later solve to light.error, as the levels so far predict them,
  /// at most light.ray_budget. Where a level would need more, or would cut few patches, the mesh is cut once
  /// more and not looked at: its error is a prediction.
  /// 0: no bound.
  double max_cost = 0.0;
  std::uint64_t free_rays = 20'000'000;  ///< that max_cost allows in any case: some 20 s of one core
  /// How the light is solved that decides. Its error: as large as the mesh error that is still there, or
  /// twice the target, but at most 10 % seen (3 % of the power); or the one here where that is larger.
  SampledOptions light = {};
  SmoothOptions smooth = {};  ///< how light is reconstructed from patches: its error is what counts
};

enum class RefineStop {
  mesh_error_reached,
  patch_limit,
  level_limit,
  cost_limit,
  drowned_in_noise,  ///< the remaining error cannot be distinguished from noise
  stopped_by_user
};

/// One mesh on the way.
struct RefineLevel {
  std::size_t patches = 0;
  double mesh_error = 0.0;      ///< as estimated for this mesh
  double sampling_error = 0.0;  ///< of the light that decided, both answers together
  std::uint64_t rays = 0;       ///< traced for it; 0: its error is a prediction
};

struct RefineReport {
  RefineStop stop = RefineStop::stopped_by_user;
  double mesh_error = 0.0;  ///< of the mesh that is the result; a solution's own error is apart from it
  std::vector<RefineLevel> levels;
  /// Where the user stopped it: one of the two answers that decided, of the patches that are the result, a
  /// solution with its errors, as rough as the refinement needed. Without light where the first level was not
  /// finished.
  Solution light;
};

/// Puts patches where the light needs them. Patches that are large in the scene, or in the eyes of the
/// views, are cut, and the light is solved coarsely. The means of the parts make the light of the whole as it
/// would be known without them; how the parts differ from the field reconstructed from that
/// (surface/smooth_light.h) is what it had wrong, d² in squares. Where light jumps, halving leaves a half of
/// a squared error, and less where it is smooth: so the parts still have d² wrong, or less, and this is the
/// mesh error that is stated. What differs most is cut in four, and the light is solved again. Each side
/// weighs by its importance for the seen error, as if d were a standard error (trace/seen_error.h); with
/// ErrorMeasure::power, and where the scene has no open space, by its area over the squared light of the
/// scene.
///
/// Each light is solved twice, independently: d² is the product of both answers' differences, in which the
/// noise of neither is, so that rough answers will do. Their streams are apart from those of other levels and
/// of a later solve.
///
/// The same bits on any number of threads. Cost: two coarse solves per level; levels grow about as the jumps
/// get longer in patches.
PatchSet refine_to_light(PatchSet patches, const RefineOptions& options, RefineReport& report,
                         const Context& context = {});

}  // namespace luxel
