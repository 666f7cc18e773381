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
  /// more without an evaluation: its error is a prediction.
  /// 0: no bound.
  double max_cost = 0.0;
  std::uint64_t free_rays = 20'000'000;  ///< that max_cost allows in any case: some 20 s of one core
  /// Options of the solves that decide about cuts. Their error: the larger of the mesh error that is left and
  /// twice the target, but at most 10 % seen (3 % of the power); or the error given here if it is larger.
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
  /// If the user stopped the refinement: one of the last two answers, for the patches of the result,
  /// with its errors, as rough as the refinement needed. Without light if the first level was not
  /// finished.
  Solution light;
};

/// Refines patches where the light needs it. Patches that are large in the scene, or as seen from the views,
/// are cut, and the light is solved coarsely. The means over the parts are the light of the whole patches as
/// if it were solved on them; the difference d of the parts from the field reconstructed from these means
/// (surface/smooth_light.h) is the error of that field, d² in squares. Where light jumps, halving leaves half
/// of a squared error, and less where it is smooth: the parts still have an error of d² or less, which is the
/// stated mesh error. The largest differences are cut in four, and the light is solved again. Each side is
/// weighted by its importance for the seen error, as if d were a standard error (trace/seen_error.h); with
/// ErrorMeasure::power, and where the scene has no open space, by its area over the squared light of the
/// scene.
///
/// Each light is solved twice, independently: d² is the product of the differences of both answers, whose
/// noise is independent, so that rough answers suffice. Their random streams differ from those of other
/// levels and of a later solve.
///
/// The same bits on any number of threads. Cost: two coarse solves per level; levels grow about as the length
/// of the jumps in patches.
PatchSet refine_to_light(PatchSet patches, const RefineOptions& options, RefineReport& report,
                         const Context& context = {});

}  // namespace luxel
