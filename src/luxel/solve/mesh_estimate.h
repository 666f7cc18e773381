// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solve/level_difference.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Fraction of its squared error that a patch keeps when it is halved where the light jumps; it keeps less
// where the light is smooth.
constexpr double left_by_halving = 0.5;

// [side]: squared error of the power per squared difference of irradiance, (m²/W)².
std::vector<double> weights_in_power(const PatchSet& patches, const Answers& answers);

// [patch]: an estimate less twice the mean noise of the patches around it in order. The noise of one
// patch is known from a single difference of two answers; where all is noise, the largest estimates are no
// error at all, and cuts by them alone follow the noise ever deeper.
std::vector<double> beyond_noise(std::span<const double> squared, std::span<const double> noise);

// Estimates the error that the size of patches leaves in the reconstructed light, and how much of it each
// patch has: see refine_to_light(). One object follows a mesh from cut to cut.
class MeshEstimate {
 public:
  // Takes what a cut changed in the field of the parts; patches that were not cut keep what their own cut had
  // changed. parent: [part].
  void note_cut(FieldDifference change, std::span<const std::uint32_t> parent, std::size_t bands);

  // Estimates what cutting each patch would change: the residual of its light, and some of what its own cut
  // changed. Weighs the sides as refine_to_light() says.
  void look(const PatchSet& patches, const Answers& answers, const Tracer& tracer, ErrorMeasure measure,
            const Context& context);

  // After a cut on which no light is found, for error(): the parts have what halving leaves.
  void predict_cut(std::span<const std::uint32_t> parent);

  // [patch]: 1 for the fewest patches whose cut leaves about `aimed` of the squared error; where that would
  // take patches with nearly all of the error, only as many as leave max_uncut of it, but at least min_count:
  // the rest is left to the next mesh, whose estimate is better. Differences that noise can explain are no
  // reason to cut, and those most above noise come first.
  std::vector<std::uint8_t> patches_to_cut(double aimed, double max_uncut, std::size_t min_count) const;

  double error() const;  // of the mesh; high by a standard error of the sum of squares
  // [patch]: what each adds to the square of the error, twice what is left by cutting it, and to that of its
  // noise. The first is unbiased as long as it decides nothing, so below 0 in places.
  std::span<const double> squared() const { return expected_.squared; }
  std::span<const double> noise() const { return expected_.noise; }
  // [side]: squared error of the whole per squared difference of irradiance, summed over bands, (m²/W)².
  std::span<const double> weights() const { return weights_; }

 private:
  FieldDifference change_;  // by the cuts that made the patches
  std::vector<double> weights_;
  Contributions expected_;  // of the next cut
};

// The mesh error of light that is known by two independent estimates (SolveHooks::halves), which had no part
// in the cuts of the mesh: from the residual alone, by the measure. Of the seen error it is that below
// which 95 % of the views stay, or a standard error of the sum of squares where noise hides it. Cost: that of
// place_views(), of a patch tree and of two make_smooth_light().
double mesh_error_of(const PatchSet& patches, const Tracer& tracer, std::array<Solution, 2> halves,
                     ErrorMeasure measure, SmoothOptions smooth, const Context& context);

}  // namespace luxel
