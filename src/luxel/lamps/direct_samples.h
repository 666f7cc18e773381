// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/work_partition.h"
#include "luxel/lamps/direct_light.h"
#include "luxel/lamps/work_units.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// Direct light of every receiver, replicate by replicate, and the samples that it is the mean of.
//
// The receivers are partitioned among processes, and all processes hold all of the light: between
// units().deal() and all_gather() each takes the samples of its own units, and holds those alone.
class DirectSamples {
 public:
  // Keeps references to light, sides and partition. width: light groups times bands.
  DirectSamples(const DirectLight& light, const GatherSides& sides, std::uint32_t replicates,
                std::size_t width, const RowPartition& partition);

  // Doubles the samples of these receivers; where there are none yet, takes `first` per replicate. Returns
  // the shadow rays that this process traced. The same bits on any number of threads.
  std::uint64_t double_samples(std::span<const std::uint32_t> receivers, std::uint32_t first,
                               const Context& context);

  // Assignment of samples to processes.
  WorkUnits& units() { return units_; }
  // After some calls of double_samples() together for these receivers: the light that each process found.
  // Returns the shadow rays of all, given one's own.
  std::uint64_t all_gather(std::span<const std::uint32_t> receivers, std::uint64_t own_rays);

  // Samples of each receiver, of one replicate.
  std::span<const std::uint32_t> samples_per_receiver() const { return samples_; }
  // [replicate][(receiver * groups + group) * bands + band], W/m².
  const std::vector<std::vector<float>>& irradiance() const { return mean_; }

  std::span<const std::uint32_t> doublings_per_receiver() const { return doublings_; }
  // Goes on where other samples of the same receivers were: each as its function above gives it.
  void restore(std::vector<std::vector<float>> irradiance, std::vector<std::uint32_t> samples,
               std::vector<std::uint32_t> doublings);

  // Drops the receivers that are not kept; the others are those of `sides` now.
  void keep(const std::vector<std::uint8_t>& kept, const GatherSides& sides);

 private:
  const DirectLight& light_;
  const GatherSides* sides_;
  std::size_t width_;
  const RowPartition& partition_;
  WorkUnits units_;
  std::vector<std::vector<float>> mean_;
  std::vector<std::uint32_t> samples_, doublings_;  // [receiver]
};

}  // namespace luxel
