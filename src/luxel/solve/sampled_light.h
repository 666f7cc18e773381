// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "luxel/classical/energy.h"
#include "luxel/classical/scattering.h"
#include "luxel/classical/solve_report.h"
#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/replicate_spread.h"
#include "luxel/solve/sampled_operator.h"
#include "luxel/surface/smoothing.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// The receivers of a sampled solve as surfaces, and the conversion of replicates to an answer.
class SampledLight {
 public:
  // Keeps references to all three. smooths: the light is smoothed where its noise needs it (from 4,096
  // receivers on).
  SampledLight(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides, bool smooths,
               const Context& context);

  std::span<const float> area() const { return area_; }  // [receiver], m²
  Scattering scattering() const { return scattering_; }  // [receiver * bands + band]

  // Called with the replicates as they are: first as they were given, then, if they are smoothed, smoothed.
  using Observer = std::function<void(bool is_smoothed)>;

  // Whether the light of the receivers' own rays is good enough without smoothing.
  using Enough = std::function<bool(const Spread&)>;

  // The mean of direct + gathered and its error, [replicate][receiver * bands + band], W/m². Where that is
  // not `enough`, both are replaced by their smoothed values. The means are not below 0, see preserve_hue().
  // not_found: variance that replicates do not show, [receiver * bands + band], see SkyNotFound. The same
  // bits on any number of threads.
  struct Answer : Spread {
    std::vector<float> bias;  // squared bias of the smoothing; empty where nothing was smoothed
  };
  Answer answer(std::span<std::vector<float>> direct, std::span<std::vector<float>> gathered,
                std::span<const float> not_found, const Enough& enough, const Context& context,
                const Observer& observe = {}) const;

  // The same of some of the replicates that answer() left; of their error only what their spread shows.
  Answer answer_of_part(Replicates direct, Replicates gathered, const Context& context) const;

  // Fills the light of the solution and all its errors.
  void write(const Answer& answer, Solution& solution, const Context& context) const;

 private:
  const PatchSet& patches_;
  const GatherSides& sides_;
  std::vector<std::uint32_t> units_;  // see preserve_hue()
  std::vector<float> area_;
  ScatteringTable scattering_;
  std::optional<Smoothing> smoothing_;
};

// The error of the whole: area-weighted relative RMS.
double error_of(const Spread& spread);

// The light of all groups together: [replicate][(receiver * groups + group) * bands + band] becomes
// [replicate][receiver * bands + band]. weight: [group * bands + band]; empty: 1 each. Sums in the order of
// groups.
std::vector<std::vector<float>> sum_of_groups(std::span<const std::vector<float>> light, std::size_t groups,
                                              std::size_t bands, std::span<const float> weight,
                                              const Context& context);

// Energy balance of a sampled solution: the power that receivers absorb, and that their rays carry to the
// sinks. The sum is exact to within the error of the light; no power is unshot. irradiance: [receiver * bands
// + band], W/m². Cost: one look-up per ray. The same bits on any number of threads.
EnergyAccount energy_of(const PatchSet& patches, const SampledOperator& transport,
                        const std::vector<float>& irradiance, const Context& context);

// Means of direct + gathered light, [replicate][receiver * bands + band], W/m², and their errors from the
// spread of the replicates' own means. At least 2 replicates, not yet smoothed: smoothing keeps the mean of a
// smooth surface, but not of each material on it. The same bits on any number of threads. Cost: 5 ns per
// receiver, replicate and band.
SurfaceMeans measure_surfaces(const PatchSet& patches, const GatherSides& sides, Replicates direct,
                              Replicates gathered, const Context& context);

}  // namespace luxel
