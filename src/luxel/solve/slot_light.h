// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "luxel/parallel/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/solution/solution.h"
#include "luxel/solve/replicate_spread.h"
#include "luxel/solve/share_light.h"
#include "luxel/transport/gather_sides.h"

namespace luxel {

// The slots of a sampled solve as surfaces, and how what replicates say of them becomes an answer.
class SlotLight {
 public:
  // Keeps references to all three. shares: neighbours may share rays (from 4,096 slots on). ranks: that all
  // ask for the same answers and share the work.
  SlotLight(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides, bool shares,
            const Workers& workers, const Ranks* ranks = nullptr);

  std::span<const float> area() const { return area_; }                // [slot], m²
  std::span<const float> reflectance() const { return reflectance_; }  // [slot * bands + band]

  // Called with the weight that the replicates as they are now have in what guides further samples.
  using Guide = std::function<void(double weight)>;

  // Whether the light of the slots' own rays is good enough, so that neighbours need not share.
  using Enough = std::function<bool(const Spread&)>;

  // The mean of direct + gathered and its error, [replicate][slot * bands + band], W/m². Where that is not
  // `enough`, neighbours share: both are replaced by what they share. The same bits on any number of threads.
  struct Answer : Spread {
    std::vector<float> bias;  // what sharing may get wrong, squared; empty where nothing was shared
  };
  Answer answer(std::span<std::vector<float>> direct, std::span<std::vector<float>> gathered,
                const Enough& enough, const Workers& workers, const Guide& guide = {}) const;

  // Fills the light of the solution and all its errors.
  void write(const Answer& answer, Solution& solution, const Workers& workers) const;

 private:
  const PatchSet& patches_;
  const GatherSides& sides_;
  const Ranks* ranks_;
  std::vector<float> area_, reflectance_;
  std::optional<LightSharing> sharing_;
};

// Of the whole: area-weighted relative RMS.
double error_of(const Spread& spread);

// The light of all groups together: [replicate][(slot * groups + group) * bands + band] becomes
// [replicate][slot * bands + band]. weight: [group * bands + band]; empty: 1 each. Sums in the order of
// groups.
std::vector<std::vector<float>> sum_of_groups(std::span<const std::vector<float>> light, std::size_t groups,
                                              std::size_t bands, std::span<const float> weight,
                                              const Workers& workers);

}  // namespace luxel
