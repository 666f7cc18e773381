// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace luxel {

// Gather rays that some receivers got together, as many as they had before or, at level 0, the first.
struct HitRound {
  std::uint32_t level = 0;  // doublings of these receivers before this one
  std::uint32_t per_replicate = 0;
  std::vector<std::uint32_t> receivers;  // rising
  // Elements hit, [replicate][place in receivers][sample]. Read-only once they are traced, so copies share
  // them; none where they are traced again whenever they are asked for.
  std::shared_ptr<std::uint32_t[]> hits;

  std::size_t hits_per_replicate() const { return receivers.size() * per_replicate; }
};

// What a sampled solve knows after a round of samples, and all that it needs to go on from there: a solve
// that takes it up gives the same bits as one that never stopped. Receivers are patch sides in the order of
// GatherSides, elements are receivers and then sinks (SampledOperator); the patches are not part of it.
struct SampleState {
  std::uint32_t replicates = 0;
  std::uint32_t rounds_done = 0;     // answers there were before this one
  std::uint64_t rays = 0;            // traced: all but those of the first pictures
  std::uint64_t first_rays = 0;      // shot for the first pictures
  std::vector<std::uint32_t> sides;  // [receiver]; sides that are not here are dark
  std::vector<HitRound> rounds;
  std::vector<std::uint32_t> direct_samples, direct_doublings;  // [receiver], of one replicate

  // [replicate], W/m²: direct light, and where it is known what surfaces send on of it, of each light group:
  // [(receiver * groups + group) * bands + band].
  std::vector<std::vector<float>> direct, gathered;
  std::vector<float> radiosity;  // reflected, where the iteration begins, W/m², [element * bands + band]
};

}  // namespace luxel
