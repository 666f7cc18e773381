// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/direct_samples.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "luxel/report/error.h"

namespace luxel {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t grain = 32;                // slots a chunk
constexpr std::uint32_t positions_a_piece = 64;  // that one rank does

}  // namespace

DirectSamples::DirectSamples(const DirectLight& light, const GatherSides& sides, std::uint32_t replicates,
                             std::size_t width, const RowShares& shares)
    : light_(light),
      sides_(&sides),
      width_(width),
      shares_(shares),
      mean_(replicates, std::vector<float>(sides.size() * width, 0.0f)),
      samples_(sides.size(), 0),
      doublings_(sides.size(), 0) {
  if (!shares.ranks() || sides.size() == 0) return;
  const auto last = *std::max_element(sides.position.begin(), sides.position.end()) / positions_a_piece;
  for (std::size_t piece = 0; piece < 2 * (last + 1); ++piece)
    owners_.push_back(static_cast<std::uint32_t>(piece / 2 % shares.ranks()->size()));
  seconds_a_sample_.resize(pieces(), 0.0);
}

std::uint64_t DirectSamples::double_samples(std::span<const std::uint32_t> slots, std::uint32_t first,
                                            const Workers& workers) {
  std::vector<std::uint64_t> traced((slots.size() + grain - 1) / grain, 0);
  std::vector<double> seconds(shares_.ranks() ? slots.size() : 0);  // for one sample
  workers.for_chunks(slots.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    std::vector<float> estimate(mean_.size() * width_);
    auto time = Clock::now();
    for (auto i = begin; i < end; ++i) {
      const auto s = slots[i];
      const auto more = samples_[s] > 0 ? samples_[s] : first;
      const auto before = samples_[s];
      samples_[s] += more;
      ++doublings_[s];
      if (!is_mine(s)) continue;
      const auto share = static_cast<float>(more) / static_cast<float>(before + more);
      traced[begin / grain] +=
          light_.estimate(sides_->side[s], sides_->position[s], doublings_[s] - 1, more, estimate);
      for (std::size_t r = 0; r < mean_.size(); ++r)
        for (std::size_t b = 0; b < width_; ++b) {
          auto& mean = mean_[r][s * width_ + b];
          mean += share * (estimate[r * width_ + b] - mean);
        }
      if (seconds.empty()) continue;
      const auto now = Clock::now();
      seconds[i] = std::chrono::duration<double>(now - time).count() / more;
      time = now;
    }
  });
  learn_pace(slots, seconds);
  return std::accumulate(traced.begin(), traced.end(), std::uint64_t{0});
}

std::size_t DirectSamples::piece_of(std::size_t slot) const {
  return 2 * (sides_->position[slot] / positions_a_piece) + (slot < sides_->fronts ? 0 : 1);
}

void DirectSamples::learn_pace(std::span<const std::uint32_t> slots, std::span<const double> seconds) {
  for (std::size_t i = 0; i < seconds.size();) {
    const auto piece = piece_of(slots[i]);
    double sum = 0.0;
    std::size_t count = 0;
    for (; i < seconds.size() && piece_of(slots[i]) == piece; ++i, ++count) sum += seconds[i];
    if (sum > 0.0) seconds_a_sample_[piece] = sum / static_cast<double>(count);
  }
}

std::vector<double> DirectSamples::expected(std::span<const double> more) const {
  std::vector<double> seconds(pieces(), 0.0);
  for (std::size_t s = 0; s < more.size(); ++s)
    if (more[s] > 0.0) seconds[piece_of(s)] += more[s] * seconds_a_sample_[piece_of(s)];
  return seconds;
}

double DirectSamples::expected_seconds(std::span<const double> more) const {
  if (!shares_.ranks()) return 0.0;
  const auto seconds = expected(more);
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

void DirectSamples::deal(std::span<const double> more, const RankTimes& times) {
  if (shares_.ranks()) owners_ = dealt_pieces(expected(more), times);
}

std::uint64_t DirectSamples::share(std::span<const std::uint32_t> slots, std::uint64_t own_rays) {
  if (!shares_.ranks()) return own_rays;
  const auto runs = RowShares::runs_of(
      slots.size(), [&](std::size_t i) { return slots[i]; },
      [&](std::size_t i) { return owners_[piece_of(slots[i])]; });
  for (auto& mean : mean_) shares_.share_runs(std::span(mean), width_, runs);
  shares_.share_of(
      std::span(seconds_a_sample_), 1, pieces(), [](std::size_t p) { return p; },
      [this](std::size_t p) { return owners_[p]; });
  const auto of_ranks = of_all(*shares_.ranks(), own_rays);
  return std::accumulate(of_ranks.begin(), of_ranks.end(), std::uint64_t{0});
}

void DirectSamples::take_up(std::vector<std::vector<float>> irradiance, std::vector<std::uint32_t> samples,
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
