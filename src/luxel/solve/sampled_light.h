// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/replicate_spread.h"
#include "luxel/surface/smoothing.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// The receivers of a sampled solve as surfaces, and how what replicates say of them becomes an answer.
class SampledLight {
 public:
  // Keeps references to all three. smooths: the light is smoothed where its noise needs it (from 4,096
  // receivers on). ranks: that all call for the same answers and share the work.
  SampledLight(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides, bool smooths,
               const Workers& workers, const Ranks* ranks = nullptr);

  std::span<const float> area() const { return area_; }                // [receiver], m²
  std::span<const float> reflectance() const { return reflectance_; }  // [receiver * bands + band]

  // Called with the replicates as they are: first as they were given, then, if they are smoothed, smoothed.
  using Observer = std::function<void(bool is_smoothed)>;

  // Whether the light of the receivers' own rays is good enough without smoothing.
  using Enough = std::function<bool(const Spread&)>;

  // The mean of direct + gathered and its error, [replicate][receiver * bands + band], W/m². Where that is
  // not `enough`, both are replaced by what smoothing makes of them. The means are not below 0, see
  // preserve_hue(). not_found: variance that replicates do not show, [receiver * bands + band], see
  // SkyNotFound. The same bits on any number of threads.
  struct Answer : Spread {
    std::vector<float> bias;  // squared bias of the smoothing; empty where nothing was smoothed
  };
  Answer answer(std::span<std::vector<float>> direct, std::span<std::vector<float>> gathered,
                std::span<const float> not_found, const Enough& enough, const Workers& workers,
                const Observer& observe = {}) const;

  // Fills the light of the solution and all its errors.
  void write(const Answer& answer, Solution& solution, const Workers& workers) const;

 private:
  const PatchSet& patches_;
  const GatherSides& sides_;
  const Ranks* ranks_;
  std::vector<std::uint32_t> units_;  // see preserve_hue()
  std::vector<float> area_, reflectance_;
  std::optional<Smoothing> smoothing_;
};

// Of the whole: area-weighted relative RMS.
double error_of(const Spread& spread);

// The light of all groups together: [replicate][(receiver * groups + group) * bands + band] becomes
// [replicate][receiver * bands + band]. weight: [group * bands + band]; empty: 1 each. Sums in the order of
// groups.
std::vector<std::vector<float>> sum_of_groups(std::span<const std::vector<float>> light, std::size_t groups,
                                              std::size_t bands, std::span<const float> weight,
                                              const Workers& workers);

}  // namespace luxel
