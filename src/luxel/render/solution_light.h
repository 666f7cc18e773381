// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/band_colours.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Source of the errors of the solution's light that rays pick up.
enum class SolutionErrors {
  not_stated,  // the method of the solution states no errors
  patches,     // the patches' standard errors, added as if all of them had the same sign: an upper bound
  replicates   // the spread of the solution's replicates, which are stored with its transport
};

// "none", "patches", "replicates".
const char* name(SolutionErrors errors);

// Throws InputError, naming the solution's file, where the bands have no luminance.
void check_has_lux(const PatchSet& patches, const std::string& file);

// lx of 1 W/m² in each band. Throws MismatchError where the bands have no luminance.
std::vector<double> lux_of_bands(const PatchSet& patches);

// Returns the illuminance of each side in each replicate of a stored run, lx: [replicate][side], before
// smoothing. Sides that no light reaches have 0. Empty where the state lacks the light of its groups
// (SampleState::gathered).
std::vector<std::vector<float>> replicate_illuminance(const PatchSet& patches, const SampleState& samples,
                                                      const Context& context);

// The standard error of a mean over replicates, widened as Student's t is; at least two.
double error_of_replicates(std::span<const double> values);

// The light of a solution as rays that end on its surfaces pick it up, and its error in photometric units.
// Read-only: any number of threads may call.
class SolutionLight {
 public:
  // Keeps references to patches and solution. samples: of the same run, or null. Throws MismatchError where
  // the solution is not of these patches or the bands have no luminance.
  SolutionLight(const PatchSet& patches, const Solution& solution, const SampleState* samples,
                const Context& context);

  std::size_t bands() const { return lux_.size(); }
  // lx of 1 W/m² in a band.
  double lux(std::size_t band) const { return lux_[band]; }
  double illuminance(std::span<const double> irradiance) const;

  // Light that the surface reflects or transmits (diffusers) at the hit of a ray, W/m²: radiance times pi,
  // from the smooth light. 0 at the backs of one-sided materials. Without emission.
  double reflected(const Hit& hit, std::size_t band) const;

  SolutionErrors errors() const { return errors_; }
  // Sums that a gatherer carries: each ray adds its weight times what its end may be off, lx. error() is the
  // standard error of sums whose weights add up to `whole`; 0 where there are none.
  std::size_t error_sums() const;
  void add_error(const Hit& hit, double weight, std::span<double> sums) const;
  double error(std::span<const double> sums, double whole) const;
  // The light of such sums in each replicate of the solution, lx; empty where there are no replicates.
  std::vector<double> replicates(std::span<const double> sums, double whole) const;
  // Degrees of freedom of these errors; 0: not from replicates, the errors are not widened.
  double error_degrees_of_freedom() const;

 private:
  const PatchSet& patches_;
  const Solution& solution_;
  std::vector<double> lux_;  // [band]
  SmoothLight smooth_;
  SolutionErrors errors_ = SolutionErrors::not_stated;
  std::vector<std::vector<float>> reflected_lux_;  // [replicate][side], where there are replicates
};

}  // namespace luxel
