// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/smoothing.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "luxel/surface/smooth_sheet.h"
#include "luxel/surface/spread_outliers.h"

namespace luxel {
namespace {

constexpr std::size_t receiver_grain = 4096;
// Threads that have nothing else to do help with a sheet larger than this; a smaller one is the work of one
// thread.
constexpr std::size_t large_sheet = 4096;
constexpr std::size_t job_receivers = 512;
constexpr std::size_t window_grain = 64;  // windows or cells of a large sheet per chunk
// Noise of direct or gathered light below which a fit is not worth its cost, over the variance of both: a
// hundredth of the noise that smoothing leaves at best.
constexpr float quiet_part = 1e-4f;
// The light, over the mean irradiance, relative to which errors do not count: that of the seen error.
constexpr double dim_part = 0.05;

using Replicates = std::span<std::vector<float>>;

// Variances over replicates, summed over bands: [i] of sheet.receivers[i].
std::vector<float> noise_of(const LightSheet& sheet, Replicates replicates, std::size_t bands,
                            const LoopRunner& run) {
  std::vector<float> noise(sheet.size(), 0.0f);
  const auto all_gather = 1.0f / static_cast<float>(replicates.size());
  run(sheet.size(), [&](std::size_t begin, std::size_t end) {
    for (auto i = begin; i < end; ++i)
      for (std::size_t b = 0; b < bands; ++b) {
        const auto at = sheet.receivers[i] * bands + b;
        float mean = 0.0f;
        for (const auto& values : replicates) mean += all_gather * values[at];
        for (const auto& values : replicates) noise[i] += (values[at] - mean) * (values[at] - mean);
      }
  });
  return noise;
}

bool has_noise(const std::vector<float>& noise) {
  return std::any_of(noise.begin(), noise.end(), [](float x) { return x > 0.0f; });
}

// Bias of all receivers, [receiver * bands + band].
struct BiasOfAll {
  std::span<float> squared;
  FineChange* fine;  // null where replicates are not independent
};

// A sheet with its windows, and the runner of its loops.
struct SheetWork {
  const LightSheet& sheet;
  std::span<const WindowGrid> grids;
  const LoopRunner& run;
};

void smooth_values(const SheetWork& work, Replicates replicates, std::size_t bands,
                   const SmoothingWeights& weights, const BiasOfAll& of_all) {
  const auto& sheet = work.sheet;
  const auto& run = work.run;
  auto* const fine = of_all.fine;
  if (!has_noise(weights.noise)) return;
  const WindowColumns columns{replicates.size(), bands};
  std::vector<float> values(sheet.size() * columns.size(), 0.0f);
  const auto for_values = [&](auto body) {
    run(sheet.size(), [&](std::size_t begin, std::size_t end) {
      for (auto i = begin; i < end; ++i)
        for (std::size_t r = 0; r < replicates.size(); ++r)
          for (std::size_t b = 0; b < bands; ++b)
            body(values[i * columns.size() + r * columns.stride() + b],
                 replicates[r][sheet.receivers[i] * bands + b]);
    });
  };
  for_values([](float& value, const float& of_receiver) { value = of_receiver; });
  spread_outliers(sheet, work.grids, columns, values, run);
  std::vector<float> bias(sheet.size() * bands);
  FineChange change;
  smooth_sheet(sheet, work.grids, columns, weights, {values, bias, fine ? &change : nullptr}, run);
  for_values([](const float& value, float& of_receiver) { of_receiver = value; });
  for (std::size_t i = 0; i < bias.size(); ++i) {
    const auto at = sheet.receivers[i / bands] * bands + i % bands;
    of_all.squared[at] += bias[i];
    if (fine) fine->product[at] = change.product[i];
    if (fine) fine->variance[at] = change.variance[i];
  }
}

// Only the sum of the bias of the finest scales over all receivers, weighted as in the seen error, can be
// separated from noise. It is distributed to where these scales removed most noise. Where replicates are not
// independent even the sum cannot be separated: products of those of gathered light are 1 to 9 % of their
// variance, less with more rays, which is the behaviour of correlated noise and not of bias.
// weight: area times risk weight, [receiver].
void add_fine_bias(FineChange& fine, std::span<const float> weight, std::size_t bands,
                   std::span<float> squared_bias, const Context& context, const LoopPartition& mine) {
  mine.all_gather(std::span(fine.product), bands);
  mine.all_gather(std::span(fine.variance), bands);
  const auto sum = [&](const std::vector<float>& numbers) {
    return ordered_sum(context, weight.size(), [&](std::size_t s) {
      float of_receiver = 0.0f;
      for (std::size_t b = 0; b < bands; ++b) of_receiver += numbers[s * bands + b];
      return static_cast<double>(weight[s] * of_receiver);
    });
  };
  const auto variance = sum(fine.variance);
  const auto part = variance > 0.0 ? static_cast<float>(sum(fine.product) / variance) : 0.0f;
  if (!(part > 0.0f)) return;
  for (std::size_t i = 0; i < squared_bias.size(); ++i) squared_bias[i] += part * fine.variance[i];
}

struct LightOfAll {
  Replicates direct, gathered;
  std::size_t bands;
  std::span<const float> risk_weight;  // [receiver]
};

// bias.fine: of direct light.
void smooth_both(const LightSheet& sheet, const LightOfAll& light, const BiasOfAll& bias,
                 const LoopRunner& run) {
  const auto& [direct, gathered, bands, risk_weight] = light;
  auto direct_noise = noise_of(sheet, direct, bands, run);
  auto gathered_noise = noise_of(sheet, gathered, bands, run);
  SmoothingWeights weights;
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    const auto risk = risk_weight[sheet.receivers[i]];
    weights.risk.push_back(risk);
    const auto quiet = quiet_part * (direct_noise[i] + gathered_noise[i]);
    direct_noise[i] = risk * (direct_noise[i] - quiet);
    gathered_noise[i] = risk * (gathered_noise[i] - quiet);
  }
  std::vector<WindowGrid> grids;
  if (sheet.size() >= min_smoothed_sheet && (has_noise(direct_noise) || has_noise(gathered_noise)))
    grids = make_window_grids(sheet);
  weights.noise = std::move(direct_noise);
  const SheetWork work{sheet, grids, run};
  smooth_values(work, direct, bands, weights, bias);
  weights.noise = std::move(gathered_noise);
  smooth_values(work, gathered, bands, weights, {bias.squared, nullptr});
}

// One sheet each, largest first, so that no thread starts a large one at the end; many tiny ones together.
std::vector<std::span<const LightSheet* const>> jobs_of(const std::vector<const LightSheet*>& sheets) {
  std::vector<std::span<const LightSheet* const>> jobs;
  for (std::size_t begin = 0, end = 0; begin < sheets.size(); begin = end) {
    std::size_t receivers = 0;
    while (end < sheets.size() && receivers < job_receivers) receivers += sheets[end++]->size();
    jobs.push_back(std::span(sheets).subspan(begin, end - begin));
  }
  return jobs;
}

}  // namespace

Smoothing::Smoothing(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides)
    : patches_(patches), sides_(sides), sheets_(make_light_sheets(patches, tree, sides)) {}

void Smoothing::smooth(std::span<std::vector<float>> direct, std::span<std::vector<float>> gathered,
                       std::span<float> squared_bias, const Context& context,
                       const LoopPartition& mine) const {
  assert(direct.size() >= 4 && gathered.size() == direct.size());
  assert(squared_bias.size() == sides_.size() * patches_.band_count());
  const auto bands = patches_.band_count();
  const auto weights = risk_weights(direct, gathered, context);
  FineChange fine;  // of direct light
  fine.product.assign(squared_bias.size(), 0.0f);
  fine.variance.assign(squared_bias.size(), 0.0f);
  const auto is_needed = [&](const LightSheet& sheet) {
    const auto at = std::lower_bound(sheet.receivers.begin(), sheet.receivers.end(), mine.begin());
    return at != sheet.receivers.end() && *at < mine.end();
  };
  const auto smooth_one = [&](const LightSheet& sheet, const LoopRunner& run) {
    smooth_both(sheet, {direct, gathered, bands, weights}, {squared_bias, &fine}, run);
  };
  const LoopRunner on_all_threads = [&](std::size_t count, const auto& body) {
    context.for_chunks(count, window_grain,
                       [&](std::size_t begin, std::size_t end, int) { body(begin, end); });
  };
  const LoopRunner on_this_thread = [](std::size_t count, const auto& body) { body(0, count); };
  std::vector<const LightSheet*> needed;
  for (const auto& sheet : sheets_)
    if (is_needed(sheet)) needed.push_back(&sheet);
  std::stable_sort(needed.begin(), needed.end(),
                   [](const auto* a, const auto* b) { return a->size() > b->size(); });
  const auto jobs = jobs_of(needed);
  context.for_chunks(jobs.size(), 1, [&](std::size_t job, std::size_t, int) {
    for (const auto* sheet : jobs[job])
      smooth_one(*sheet, sheet->size() < large_sheet ? on_this_thread : on_all_threads);
  });
  std::vector<float> area_weight;
  for (std::size_t s = 0; s < sides_.size(); ++s)
    area_weight.push_back(patches_.area[sides_.side[s].patch()] * weights[s]);
  add_fine_bias(fine, area_weight, bands, squared_bias, context, mine);
}

// 1 over the square of a receiver's light plus a fraction of the mean: [receiver], (m²/W)².
std::vector<float> Smoothing::risk_weights(std::span<const std::vector<float>> direct,
                                           std::span<const std::vector<float>> gathered,
                                           const Context& context) const {
  const auto bands = patches_.band_count();
  const auto receivers = sides_.size();
  std::vector<float> light(receivers);
  context.for_chunks(receivers, receiver_grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto s = begin; s < end; ++s) {
      float sum = 0.0f;
      for (std::size_t r = 0; r < direct.size(); ++r)
        for (std::size_t b = 0; b < bands; ++b) sum += direct[r][s * bands + b] + gathered[r][s * bands + b];
      light[s] = std::max(0.0f, sum / static_cast<float>(direct.size()));
    }
  });
  const auto area = [&](std::size_t s) { return static_cast<double>(patches_.area[sides_.side[s].patch()]); };
  const auto areas =
      ordered_sum(context, receivers, [&](std::size_t s) { return light[s] > 0.0f ? area(s) : 0.0; });
  const auto power =
      ordered_sum(context, receivers, [&](std::size_t s) { return area(s) * static_cast<double>(light[s]); });
  const auto floor = areas > 0.0 ? static_cast<float>(dim_part * power / areas) : 0.0f;
  for (auto& x : light) x = floor > 0.0f ? 1.0f / ((x + floor) * (x + floor)) : 1.0f;
  return light;
}

}  // namespace luxel
