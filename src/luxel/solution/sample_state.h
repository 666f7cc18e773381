// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "luxel/patch/side.h"

namespace luxel {

// Gather rays of some receivers: each doubles the receiver's rays or, at level 0, is its first set.
struct HitRound {
  std::uint32_t level = 0;  // doublings of these receivers before this one
  std::uint32_t per_replicate = 0;
  std::vector<std::uint32_t> receivers;  // rising
  // Elements hit, [replicate][place in receivers][sample]. Read-only once they are traced, so copies share
  // them; none where they are traced again at each use.
  std::shared_ptr<std::uint32_t[]> hits;

  std::size_t hits_per_replicate() const { return receivers.size() * per_replicate; }
};

// The complete state of a sampled solve after a round of samples: a solve that resumes from it gives the same
// bits as one that was never interrupted. Receivers are patch sides in the order of GatherSides, elements are
// receivers and then sinks (SampledOperator); the patches are not part of it.
struct SampleState {
  std::uint32_t replicates = 0;
  std::uint32_t rounds_done = 0;  // answers there were before this one
  std::uint64_t rays = 0;         // traced: all but those of the first pictures
  std::uint64_t first_rays = 0;   // shot for the first pictures
  std::vector<SideId> sides;      // [receiver]; sides that are not here are dark
  std::vector<HitRound> rounds;
  std::vector<std::uint32_t> direct_samples, direct_doublings;  // [receiver], of one replicate

  // [replicate], W/m²: direct light and, where known, the light that surfaces reflect of it, of each light
  // group: [(receiver * groups + group) * bands + band].
  std::vector<std::vector<float>> direct, gathered;
  std::vector<float> radiosity;  // reflected, where the iteration begins, W/m², [element * bands + band]
};

}  // namespace luxel
