// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/smoothing.h"

#include <algorithm>
#include <utility>

#include "luxel/solve/smooth_sheet.h"

namespace luxel {
namespace {

constexpr std::size_t slot_grain = 4096;
// Sheets above this share the threads; smaller ones are one thread's work each.
constexpr std::size_t large_sheet = 8192;
constexpr std::size_t sheet_grain = 8;    // small sheets per chunk
constexpr std::size_t window_grain = 64;  // windows or cells of a large sheet per chunk
// Noise of direct or gathered light that is not worth a fit, over the variance of both: a hundredth of what
// smoothing leaves of it where it works best.
constexpr float quiet_part = 1e-4f;
// The light beside which errors do not count, over the mean irradiance: that of the seen error.
constexpr double dim_part = 0.05;

using Replicates = std::span<std::vector<float>>;

// Variances over replicates, summed over bands: [i] of sheet.slots[i].
std::vector<float> noise_of(const LightSheet& sheet, Replicates replicates, std::size_t bands) {
  std::vector<float> noise(sheet.size(), 0.0f);
  const auto share = 1.0f / static_cast<float>(replicates.size());
  for (std::size_t i = 0; i < sheet.size(); ++i)
    for (std::size_t b = 0; b < bands; ++b) {
      const auto at = sheet.slots[i] * bands + b;
      float mean = 0.0f;
      for (const auto& values : replicates) mean += share * values[at];
      for (const auto& values : replicates) noise[i] += (values[at] - mean) * (values[at] - mean);
    }
  return noise;
}

void smooth_values(const LightSheet& sheet, Replicates replicates, std::size_t bands,
                   const SmoothingWeights& weights, std::span<float> squared_bias, const LoopRunner& run) {
  if (std::none_of(weights.noise.begin(), weights.noise.end(), [](float x) { return x > 0.0f; })) return;
  const WindowColumns columns{replicates.size(), bands};
  std::vector<float> values(sheet.size() * columns.size(), 0.0f);
  const auto for_values = [&](auto body) {
    for (std::size_t i = 0; i < sheet.size(); ++i)
      for (std::size_t r = 0; r < replicates.size(); ++r)
        for (std::size_t b = 0; b < bands; ++b)
          body(values[i * columns.size() + r * columns.stride() + b],
               replicates[r][sheet.slots[i] * bands + b]);
  };
  for_values([](float& value, const float& of_slot) { value = of_slot; });
  std::vector<float> bias(sheet.size() * bands);
  smooth_sheet(sheet, columns, weights, values, bias, run);
  for_values([](const float& value, float& of_slot) { of_slot = value; });
  for (std::size_t i = 0; i < sheet.size(); ++i)
    for (std::size_t b = 0; b < bands; ++b) squared_bias[sheet.slots[i] * bands + b] += bias[i * bands + b];
}

// risk_weight: [slot].
void smooth_both(const LightSheet& sheet, Replicates direct, Replicates gathered, std::size_t bands,
                 std::span<const float> risk_weight, std::span<float> squared_bias, const LoopRunner& run) {
  auto direct_noise = noise_of(sheet, direct, bands);
  auto gathered_noise = noise_of(sheet, gathered, bands);
  SmoothingWeights weights;
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    const auto risk = risk_weight[sheet.slots[i]];
    weights.risk.push_back(risk);
    const auto quiet = quiet_part * (direct_noise[i] + gathered_noise[i]);
    direct_noise[i] = risk * (direct_noise[i] - quiet);
    gathered_noise[i] = risk * (gathered_noise[i] - quiet);
  }
  weights.noise = std::move(direct_noise);
  smooth_values(sheet, direct, bands, weights, squared_bias, run);
  weights.noise = std::move(gathered_noise);
  smooth_values(sheet, gathered, bands, weights, squared_bias, run);
}

}  // namespace

Smoothing::Smoothing(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides)
    : patches_(patches), sides_(sides), sheets_(make_light_sheets(patches, tree, sides)) {}

void Smoothing::smooth(std::span<std::vector<float>> direct, std::span<std::vector<float>> gathered,
                       std::span<float> squared_bias, const Workers& workers, const LoopShare& mine) const {
  const auto bands = patches_.band_count();
  const auto weights = risk_weights(direct, gathered, workers);
  const auto is_needed = [&](const LightSheet& sheet) {
    const auto at = std::lower_bound(sheet.slots.begin(), sheet.slots.end(), mine.begin());
    return at != sheet.slots.end() && *at < mine.end();
  };
  const auto smooth_one = [&](const LightSheet& sheet, const LoopRunner& run) {
    smooth_both(sheet, direct, gathered, bands, weights, squared_bias, run);
  };
  const LoopRunner on_all_threads = [&](std::size_t count, const auto& body) {
    workers.for_chunks(count, window_grain,
                       [&](std::size_t begin, std::size_t end, int) { body(begin, end); });
  };
  const LoopRunner on_this_thread = [](std::size_t count, const auto& body) { body(0, count); };
  std::vector<const LightSheet*> small;
  for (const auto& sheet : sheets_) {
    if (!is_needed(sheet)) continue;
    if (sheet.size() < large_sheet) {
      small.push_back(&sheet);
    } else {
      smooth_one(sheet, on_all_threads);
    }
  }
  // Large ones first, so that no thread is left with one at the end.
  std::stable_sort(small.begin(), small.end(),
                   [](const auto* a, const auto* b) { return a->size() > b->size(); });
  std::size_t tiny = 0;
  while (tiny < small.size() && small[tiny]->size() >= slot_grain / sheet_grain) ++tiny;
  const auto several = std::span(small).subspan(tiny);
  workers.for_chunks(tiny, 1,
                     [&](std::size_t i, std::size_t, int) { smooth_one(*small[i], on_this_thread); });
  workers.for_chunks(several.size(), sheet_grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) smooth_one(*several[i], on_this_thread);
  });
}

// 1 over the square of a slot's light and a part of the mean: [slot], (m²/W)².
std::vector<float> Smoothing::risk_weights(std::span<const std::vector<float>> direct,
                                           std::span<const std::vector<float>> gathered,
                                           const Workers& workers) const {
  const auto bands = patches_.band_count();
  const auto slots = sides_.size();
  std::vector<float> light(slots);
  workers.for_chunks(slots, slot_grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto s = begin; s < end; ++s) {
      float sum = 0.0f;
      for (std::size_t r = 0; r < direct.size(); ++r)
        for (std::size_t b = 0; b < bands; ++b) sum += direct[r][s * bands + b] + gathered[r][s * bands + b];
      light[s] = std::max(0.0f, sum / static_cast<float>(direct.size()));
    }
  });
  const auto area = [&](std::size_t s) { return static_cast<double>(patches_.area[sides_.side[s] / 2]); };
  const auto areas =
      ordered_sum(workers, slots, [&](std::size_t s) { return light[s] > 0.0f ? area(s) : 0.0; });
  const auto power =
      ordered_sum(workers, slots, [&](std::size_t s) { return area(s) * static_cast<double>(light[s]); });
  const auto floor = areas > 0.0 ? static_cast<float>(dim_part * power / areas) : 0.0f;
  for (auto& x : light) x = floor > 0.0f ? 1.0f / ((x + floor) * (x + floor)) : 1.0f;
  return light;
}

}  // namespace luxel
