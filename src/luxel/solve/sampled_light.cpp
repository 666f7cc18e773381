// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sampled_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "luxel/solution/error_95th.h"
#include "luxel/surface/preserve_hue.h"

namespace luxel {
namespace {

constexpr std::size_t grain = 4096;          // receivers per chunk
constexpr std::uint32_t hue_positions = 64;  // neighbours whose mean colour stands in for that of one of them
// With fewer receivers there are few windows, so the estimate of their bias is too noisy, and there is little
// to gain.
constexpr std::size_t min_smoothed_receivers = 4096;

}  // namespace

SampledLight::SampledLight(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides,
                           bool smooths, const Workers& workers, const Ranks* ranks)
    : patches_(patches), sides_(sides), ranks_(ranks), units_(neighbour_begins(sides, hue_positions)) {
  const auto bands = patches.band_count();
  area_.resize(sides.size());
  reflectance_.resize(sides.size() * bands);
  workers.for_chunks(sides.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto s = begin; s < end; ++s) {
      const auto patch = sides.side[s] / 2;
      area_[s] = patches.area[patch];
      for (std::size_t b = 0; b < bands; ++b) reflectance_[s * bands + b] = patches.reflectance(patch, b);
    }
  });
  if (smooths && sides.size() >= min_smoothed_receivers) smoothing_.emplace(patches, tree, sides);
}

SampledLight::Answer SampledLight::answer(std::span<std::vector<float>> direct,
                                          std::span<std::vector<float>> gathered,
                                          std::span<const float> not_found, const Enough& enough,
                                          const Workers& workers, const Observer& observe) const {
  const auto bands = patches_.band_count();
  if (observe) observe(false);
  // Smoothing only where it is needed: the patches' own rays make no assumption.
  auto own = spread_of_sum(direct, gathered, not_found, bands, area_, workers, 1, ranks_);
  if (!smoothing_ || enough(own)) {
    preserve_hue(own.mean, bands, area_, units_);
    return {std::move(own), {}};
  }
  const auto mine = spread_partition(ranks_, area_.size());
  std::vector<float> bias(reflectance_.size(), 0.0f);
  smoothing_->smooth(direct, gathered, bias, workers, mine);
  if (observe) observe(true);
  constexpr std::size_t families = 2;  // of replicates: each half has a mean of its own
  auto not_shown = bias;
  std::transform(bias.begin(), bias.end(), not_found.begin(), not_shown.begin(), std::plus<>());
  auto spread = spread_of_sum(direct, gathered, not_shown, bands, area_, workers, families, ranks_);
  mine.all_gather(std::span(bias), bands);
  preserve_hue(spread.mean, bands, area_, units_);
  return {std::move(spread), std::move(bias)};
}

void SampledLight::write(const Answer& answer, Solution& solution, const Workers& workers) const {
  const auto bands = patches_.band_count();
  const auto numbers = patches_.size() * bands;
  auto& s = solution;
  const bool shared = !answer.bias.empty();
  const std::array arrays = {&s.irradiance_front,     &s.irradiance_back,      &s.radiosity_front,
                             &s.radiosity_back,       &s.standard_error_front, &s.standard_error_back,
                             &s.smoothing_bias_front, &s.smoothing_bias_back};
  workers.for_chunks(arrays.size(), 1, [&](std::size_t i, std::size_t, int) {
    arrays[i]->assign(shared || i < arrays.size() - 2 ? numbers : 0, 0.0f);
  });
  workers.for_chunks(patches_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto p = begin; p < end; ++p)
      for (std::size_t b = 0; b < bands; ++b) s.radiosity_front[p * bands + b] = patches_.emittance(p, b);
  });
  workers.for_chunks(area_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto receiver = begin; receiver < end; ++receiver) {
      const auto side = sides_.side[receiver];
      const bool back = side % 2 == 1;
      for (std::size_t b = 0; b < bands; ++b) {
        const auto i = receiver * bands + b;
        const auto at = side / 2 * bands + b;
        const auto H = std::max(0.0f, answer.mean[i]);
        (back ? s.irradiance_back : s.irradiance_front)[at] = H;
        (back ? s.radiosity_back : s.radiosity_front)[at] += reflectance_[i] * H;
        (back ? s.standard_error_back : s.standard_error_front)[at] = answer.standard_error[i];
        if (shared)
          (back ? s.smoothing_bias_back : s.smoothing_bias_front)[at] =
              std::sqrt(std::max(0.0f, answer.bias[i]));
      }
    }
  });
  s.bands = patches_.bands;
  s.error_95th = error_95th_of(s);
  s.predicted_error = error_of(answer);
  s.predicted_bias = answer.total_squared_light > 0.0
                         ? std::sqrt(answer.total_squared_bias / answer.total_squared_light)
                         : 0.0;
  s.error_degrees_of_freedom = answer.degrees_of_freedom;
}

double error_of(const Spread& spread) {
  return spread.total_squared_light > 0.0
             ? std::sqrt(std::max(0.0, spread.total_squared_error) / spread.total_squared_light)
             : 0.0;
}

std::vector<std::vector<float>> sum_of_groups(std::span<const std::vector<float>> light, std::size_t groups,
                                              std::size_t bands, std::span<const float> weight,
                                              const Workers& workers) {
  if (groups == 1 && weight.empty()) return {light.begin(), light.end()};
  const auto width = groups * bands;
  std::vector<std::vector<float>> sum;
  for (const auto& from : light) {
    const auto receivers = from.size() / width;
    auto& to = sum.emplace_back(receivers * bands);
    workers.for_chunks(receivers, grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto s = begin; s < end; ++s)
        for (std::size_t b = 0; b < bands; ++b) {
          float total = 0.0f;
          for (std::size_t g = 0; g < groups; ++g) {
            const auto value = from[s * width + g * bands + b];
            total += weight.empty() ? value : weight[g * bands + b] * value;
          }
          to[s * bands + b] = total;
        }
    });
  }
  return sum;
}

}  // namespace luxel
