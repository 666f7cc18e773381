// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/render/solution_light.h"
#include "luxel/solution/solution.h"

namespace luxel {

// A number and an interval that contains its true value with a probability of at least 95 %; without errors
// both ends are the value.
struct MeasuredNumber {
  double value = 0.0, low = 0.0, high = 0.0;
};

enum class SurfaceSide {
  automatic,  // the one that receives more light
  front,
  back
};

// The illuminance of one side of a set of patches, lx: of the patches' means on this mesh. Patches that
// (nearly) no light reaches, such as the floor below a cabinet, are left out, and their area is stated: those
// with less than a ten-thousandth of the mean of all. Where all are dark, they all count.
struct SurfaceMeasure {
  bool back = false;
  std::size_t patches = 0;
  double area = 0.0;   // m², of that side
  double unlit = 0.0;  // m², further area that no light reaches
  MeasuredNumber mean, min, max;
  MeasuredNumber min_over_mean, min_over_max;  // uniformity; 0 where all is dark
  std::uint32_t darkest = 0, brightest = 0;    // patches
};

// The light of a solution by surfaces, with intervals.
//
// Mean: weighted by area. Its standard error comes from the spread of the replicates' own means, where they
// are given; otherwise it is the area-weighted mean of the patches' standard errors, as if all errors had the
// same sign: an upper bound. Minimum and maximum: of the patches' values e with standard errors s. Each patch
// may be the true extreme, so the interval of the minimum runs from min(e - t s) to min(e + t' s), with t of
// Student's t for a tail of 2.5 %, and t' for 2.5 % divided by the number of patches (Bonferroni): its low
// end needs no such correction (intersection-union test, Berger 1982). Both hold for any dependence between
// patches. The observed minimum itself is biased towards darkness by noise. Uniformities are formed from the
// ends of both intervals, each for half of the risk.
class SurfaceMeter {
 public:
  // Keeps references. replicates: [replicate][side], lx, see replicate_illuminance(); may be empty. Throws
  // MismatchError where the bands have no luminance.
  SurfaceMeter(const PatchSet& patches, const Solution& solution, std::vector<std::vector<float>> replicates);

  // Source of the intervals of means; those of extremes come from the patches.
  SolutionErrors errors_of_means() const;
  bool has_errors_of_patches() const { return !solution_.standard_error.front.empty(); }
  // among: indices of at least one patch.
  SurfaceMeasure measure(std::span<const std::uint32_t> among, SurfaceSide side) const;

 private:
  // Returns those of the patches whose side light reaches; all of them if none.
  std::vector<std::uint32_t> lit(std::span<const std::uint32_t> selected, bool back) const;
  MeasuredNumber mean(std::span<const std::uint32_t> selected, bool back, double risk) const;
  // sign: 1 for the minimum, -1 for the maximum.
  MeasuredNumber extreme(std::span<const std::uint32_t> selected, bool back, double risk, double sign,
                         std::uint32_t* where) const;
  double illuminance(std::uint32_t patch, bool back) const;
  double error(std::uint32_t patch, bool back) const;  // lx, not widened
  double area(std::uint32_t patch) const { return static_cast<double>(patches_.area[patch]); }

  const PatchSet& patches_;
  const Solution& solution_;
  std::vector<double> lux_;  // [band]
  std::vector<std::vector<float>> replicates_;
};

}  // namespace luxel
