// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/work_partition.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/surface/light_sheets.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// Smooths the noise of replicates by local polynomial regression over every smooth surface, see
// smooth_sheet.h. Direct and gathered light are smoothed apart, because edges of shadows are in the one and
// most of the noise is in the other.
class Smoothing {
 public:
  // Keeps references to patches and sides. See make_light_sheets() for the cost.
  Smoothing(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides);

  // direct, gathered: [replicate][receiver * bands + band], W/m², at least 4 replicates, are replaced.
  // squared_bias: [receiver * bands + band], W²/m⁴, receives the estimated error of the smoothing of both in
  // addition; it may be below 0 in places. The same bits on any number of threads. mine: of several
  // processes, the receivers whose values this one needs: it gets those, and some others beside them. Cost: 2
  // to 6 us per receiver of 8 replicates and 3 bands, for both.
  void smooth(std::span<std::vector<float>> direct, std::span<std::vector<float>> gathered,
              std::span<float> squared_bias, const Context& context, const LoopPartition& mine) const;

 private:
  std::vector<float> risk_weights(std::span<const std::vector<float>> direct,
                                  std::span<const std::vector<float>> gathered, const Context& context) const;

  const PatchSet& patches_;
  const GatherSides& sides_;
  std::vector<LightSheet> sheets_;
};

}  // namespace luxel
