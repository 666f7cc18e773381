// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/direct_samples.h"

#include <numeric>

namespace luxel {
namespace {

constexpr std::size_t grain = 256;  // slots a chunk

}  // namespace

DirectSamples::DirectSamples(const DirectLight& light, const GatherSides& sides, std::uint32_t replicates,
                             std::size_t bands)
    : light_(light),
      sides_(&sides),
      bands_(bands),
      mean_(replicates, std::vector<float>(sides.size() * bands, 0.0f)),
      samples_(sides.size(), 0),
      doublings_(sides.size(), 0) {}

std::uint64_t DirectSamples::double_samples(std::span<const std::uint32_t> slots, std::uint32_t first,
                                            const Workers& workers) {
  std::vector<std::uint64_t> traced((slots.size() + grain - 1) / grain, 0);
  workers.for_chunks(slots.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    std::vector<float> estimate(mean_.size() * bands_);
    for (auto i = begin; i < end; ++i) {
      const auto s = slots[i];
      const auto more = samples_[s] > 0 ? samples_[s] : first;
      const auto share = static_cast<float>(more) / static_cast<float>(samples_[s] + more);
      traced[begin / grain] +=
          light_.estimate(sides_->side[s], sides_->position[s], doublings_[s], more, estimate);
      for (std::size_t r = 0; r < mean_.size(); ++r)
        for (std::size_t b = 0; b < bands_; ++b) {
          auto& mean = mean_[r][s * bands_ + b];
          mean += share * (estimate[r * bands_ + b] - mean);
        }
      samples_[s] += more;
      ++doublings_[s];
    }
  });
  return std::accumulate(traced.begin(), traced.end(), std::uint64_t{0});
}

void DirectSamples::keep(const std::vector<std::uint8_t>& kept, const GatherSides& sides) {
  const auto close_up = [&](auto& values, std::size_t width) {
    std::size_t to = 0;
    for (std::size_t s = 0; s < kept.size(); ++s)
      if (kept[s])
        for (std::size_t i = 0; i < width; ++i) values[to++] = values[s * width + i];
    values.resize(to);
  };
  for (auto& m : mean_) close_up(m, bands_);
  close_up(samples_, 1);
  close_up(doublings_, 1);
  sides_ = &sides;
}

}  // namespace luxel
