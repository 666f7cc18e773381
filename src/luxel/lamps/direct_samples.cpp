// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/direct_samples.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <numeric>

#include "luxel/core/error.h"

namespace luxel {
namespace {

constexpr std::size_t grain = 32;  // receivers per chunk

using Clock = std::chrono::steady_clock;

}  // namespace

DirectSamples::DirectSamples(const DirectLight& light, const GatherSides& sides, std::uint32_t replicates,
                             std::size_t width, const RowPartition& partition)
    : light_(light),
      sides_(&sides),
      width_(width),
      partition_(partition),
      units_(partition, sides),
      mean_(replicates, std::vector<float>(sides.size() * width, 0.0f)),
      samples_(sides.size(), 0),
      doublings_(sides.size(), 0) {}

std::uint64_t DirectSamples::double_samples(std::span<const std::uint32_t> receivers, std::uint32_t first,
                                            const Context& context) {
  std::vector<std::uint64_t> traced((receivers.size() + grain - 1) / grain, 0);
  std::vector<double> seconds(partition_.is_shared() ? receivers.size() : 0);  // for one sample
  context.for_chunks(receivers.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    std::vector<float> estimate(mean_.size() * width_);
    auto time = Clock::now();
    for (auto i = begin; i < end; ++i) {
      const auto s = receivers[i];
      const auto more = samples_[s] > 0 ? samples_[s] : first;
      const auto before = samples_[s];
      samples_[s] += more;
      ++doublings_[s];
      if (!units_.is_mine(s)) continue;
      const auto all_gather = static_cast<float>(more) / static_cast<float>(before + more);
      traced[begin / grain] +=
          light_.estimate(sides_->side[s], sides_->position[s], doublings_[s] - 1, more, estimate);
      for (std::size_t r = 0; r < mean_.size(); ++r)
        for (std::size_t b = 0; b < width_; ++b) {
          auto& mean = mean_[r][s * width_ + b];
          mean += all_gather * (estimate[r * width_ + b] - mean);
        }
      if (seconds.empty()) continue;
      const auto now = Clock::now();
      seconds[i] = std::chrono::duration<double>(now - time).count() / more;
      time = now;
    }
  });
  units_.learn(receivers, seconds);
  return std::accumulate(traced.begin(), traced.end(), std::uint64_t{0});
}

std::uint64_t DirectSamples::all_gather(std::span<const std::uint32_t> receivers, std::uint64_t own_rays) {
  if (!partition_.is_shared()) return own_rays;
  units_.all_gather(mean_, width_, receivers);
  const auto rays = partition_.all_gather_value(own_rays);
  return std::accumulate(rays.begin(), rays.end(), std::uint64_t{0});
}

void DirectSamples::restore(std::vector<std::vector<float>> irradiance, std::vector<std::uint32_t> samples,
                            std::vector<std::uint32_t> doublings) {
  const auto fits = [&](const std::vector<float>& values) { return values.size() == mean_[0].size(); };
  if (irradiance.size() != mean_.size() || !std::all_of(irradiance.begin(), irradiance.end(), fits) ||
      samples.size() != samples_.size() || doublings.size() != doublings_.size())
    throw MismatchError("the kept direct light does not belong to these patches");
  mean_ = std::move(irradiance);
  samples_ = std::move(samples);
  doublings_ = std::move(doublings);
}

void DirectSamples::keep(const std::vector<std::uint8_t>& kept, const GatherSides& sides) {
  assert(kept.size() == samples_.size());
  const auto close_up = [&](auto& values, std::size_t width) {
    std::size_t to = 0;
    for (std::size_t s = 0; s < kept.size(); ++s)
      if (kept[s])
        for (std::size_t i = 0; i < width; ++i) values[to++] = values[s * width + i];
    values.resize(to);
  };
  for (auto& m : mean_) close_up(m, width_);
  close_up(samples_, 1);
  close_up(doublings_, 1);
  sides_ = &sides;
}

}  // namespace luxel
