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
  /// Above this number of patches another level follows only where the last lowered the estimated error by
  /// two fifths, up to max_patches.
  std::size_t usual_patches = 1'000'000;
  int max_levels = 40;
  /// Rays of the refinement over those of a later solve to light.error, as the first level predicts them,
  /// at most light.ray_budget. Where a level would need more, or would cut few patches, the mesh is cut once
  /// more without an evaluation: its error is a prediction.
  /// 0: no bound.
  double max_cost = 0.0;
  std::uint64_t free_rays = 20'000'000;  ///< that max_cost allows in any case: some 20 s of one core
  /// Options of the solves, of the first mesh and of the last. Their error: the larger of the mesh error that
  /// is left and twice the target, but at most 10 % seen (3 % of the power). With max_cost only the first
  /// mesh is solved, to mesh_error, by at most 0.4 of free_rays or 64 rays per side. The error given here
  /// counts if it is larger.
  SampledOptions light = {};
  SmoothOptions smooth = {};  ///< how light is reconstructed from patches: its error is what counts
  /// The solve that follows, for Progress::later alone: its requested error and SampledOptions::ray_budget.
  /// Error 0: none follows.
  double later_error = 0.0;
  std::uint64_t later_ray_budget = 0;
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
  /// The mesh error of the result, estimated from the light that decided about the cuts. It does not include
  /// sampling error.
  double mesh_error = 0.0;
  std::vector<RefineLevel> levels;
  /// If the user stopped the refinement: the mean of the last two answers, for the patches of the result,
  /// with its errors, as rough as the refinement needed. Without light if the first level was not
  /// finished.
  Solution light;
};

/// Refines patches where the light needs it. Patches that are large in the scene, or as seen from the views,
/// are cut, and the light is solved coarsely. The error of a patch is estimated by what cutting it would
/// change: the squared residual of the field reconstructed from the means of the patches
/// (surface/smooth_light.h), the mean of a patch against the field on it, and a tenth of the squared change
/// that the patch's own cut made to that field. Where light jumps, halving changes half of a squared error,
/// and more where it is smooth: the mesh error is the root of twice the sum. Each side is weighted by its
/// importance for the seen error, as if its difference were a standard error (trace/seen_error.h); with
/// ErrorMeasure::power, and where the scene has no open space, by its area over the squared light of the
/// scene. On a face of a curved surface, such as a ball, only what differs within the face counts.
///
/// The mean of a patch does not show how light varies within it. So after the first light patches are cut on
/// trial, first those that are large as seen from the views; the cuts remain where the parts differ by more
/// than noise (solve/trial_cuts.h).
///
/// The patches with the largest estimates are cut in four, a few at a time. The parts gather the light of the
/// scene as it is known (solve/part_light.h): the cost of a level is that of its parts. When the target seems
/// reached, the light is solved again on the mesh, since estimates that decided about cuts are too low where
/// they were kept; the refinement ends where the new ones confirm it. With a bound on the cost, only if that
/// allows it.
///
/// All light is found twice, independently: squares are products of both answers, whose noise is independent,
/// so that rough answers suffice. Where the whole scene is solved they are the halves of the replicates of
/// one solve. Random streams differ from those of other levels and of a later solve.
///
/// The same bits on any number of threads. Cost: a coarse solve, trials that mostly take fewer rays than it
/// (at most 7 times as many), another solve on the last mesh, and for each part at most 512 rays.
PatchSet refine_to_light(PatchSet patches, const RefineOptions& options, RefineReport& report,
                         const Context& context = {});

}  // namespace luxel
