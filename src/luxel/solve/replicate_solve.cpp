// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/replicate_solve.h"

#include <algorithm>
#include <cassert>

#include "luxel/solve/tuning.h"

namespace luxel {
namespace {

using namespace tuning::influence;

template <typename Body>
void for_all(std::size_t count, const Context& context, Body body) {
  context.for_chunks(count, grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) body(i);
  });
}

std::vector<float> twice(std::span<const float> values) {
  std::vector<float> both(values.begin(), values.end());
  both.insert(both.end(), values.begin(), values.end());
  return both;
}

struct InfluenceInput {
  std::span<const std::vector<float>> direct;  // of the half's replicates
  std::span<const float> mean_direct;          // of all replicates
  Scattering scattering;
  std::span<const float> mean;  // of all h_r
};

// The light of each receiver in one number in place of bands, so that what is sent on costs one column per
// replicate. Exact where all light has one colour.
struct Grey {
  // [receiver], of the light that falls on it and, the transmittance, on the other side
  std::vector<float> reflectance, transmittance;
  std::vector<float> colour;  // gathered light over its mean over bands, [receiver * bands + band]
};

Grey grey_of(const InfluenceInput& input, std::size_t bands, const Context& context) {
  const auto& scattering = input.scattering;
  const auto count = scattering.reflectance.size();
  Grey grey{std::vector<float>(count / bands), std::vector<float>(scattering.far.size()),
            std::vector<float>(count, 1.0f)};
  for_all(grey.reflectance.size(), context, [&](std::size_t s) {
    float light = 0.0f, reflected = 0.0f, gathered = 0.0f, plain = 0.0f;
    for (auto i = s * bands; i < (s + 1) * bands; ++i) {
      const auto in = std::max(0.0f, input.mean_direct[i] + input.mean[i]);
      light += in;
      reflected += scattering.reflectance[i] * in;
      gathered += std::max(0.0f, input.mean[i]);
      plain += scattering.reflectance[i] / static_cast<float>(bands);
    }
    grey.reflectance[s] = light > 0.0f ? reflected / light : plain;
    for (auto i = s * bands; gathered > 0.0f && i < (s + 1) * bands; ++i)
      grey.colour[i] = static_cast<float>(bands) * std::max(0.0f, input.mean[i]) / gathered;
  });
  for_all(grey.transmittance.size(), context, [&](std::size_t s) {
    float light = 0.0f, transmitted = 0.0f, plain = 0.0f;
    for (std::size_t b = 0; b < bands; ++b) {
      const auto i = s * bands + b, j = scattering.far[s] * bands + b;
      const auto in = std::max(0.0f, input.mean_direct[j] + input.mean[j]);
      light += in;
      transmitted += scattering.transmittance[i] * in;
      plain += scattering.transmittance[i] / static_cast<float>(bands);
    }
    grey.transmittance[s] = light > 0.0f ? transmitted / light : plain;
  });
  return grey;
}

// Adds to each replicate of one half the effect of its own noise on the reflected light. gathered: on entry
// h_r, on return u_r - (D_r - mean of D). Returns false if the monitor stops the work.
bool add_influences(const SampledOperator& transport, std::size_t half, const InfluenceInput& input,
                    std::span<std::vector<float>> gathered, const Context& context) {
  const auto receivers = transport.sides().size();
  const auto bands = input.mean.size() / std::max<std::size_t>(1, receivers);
  const auto columns = gathered.size();
  const auto grey = grey_of(input, bands, context);
  std::vector<float> source(receivers * columns), reflectances(source.size()), influence(source.size());
  std::vector<float> transmittances(grey.transmittance.size() * columns);
  std::vector<float> radiosity(transport.elements() * columns, 0.0f);
  const auto own = [&](std::size_t k, std::size_t i) {
    return gathered[k][i] - input.mean[i] + input.direct[k][i] - input.mean_direct[i];
  };
  for_all(receivers, context, [&](std::size_t s) {
    for (std::size_t k = 0; k < columns; ++k) {
      const auto at = s * columns + k;
      float sum = 0.0f;
      for (auto i = s * bands; i < (s + 1) * bands; ++i) sum += own(k, i);
      source[at] = sum / static_cast<float>(bands);
      reflectances[at] = grey.reflectance[s];
      if (!transmittances.empty()) transmittances[at] = grey.transmittance[s];
    }
  });
  const Scattering scattering(reflectances, transmittances, input.scattering.far);
  for_all(source.size(), context,
          [&](std::size_t at) { radiosity[at] = scattering.sent_on(source, at, columns); });
  const auto report =
      gauss_seidel(HalfOperator(transport, 1 - half, columns), {source, scattering, radiosity, influence},
                   {.tolerance = influence_tolerance,
                    .parts = 1,
                    .memory = influence_memory,
                    .sum_tolerance = influence_sum_tolerance},
                   context);
  if (report.is_stopped) return false;
  for_all(receivers, context, [&](std::size_t s) {
    for (std::size_t k = 0; k < columns; ++k) {
      const auto sent_on = influence[s * columns + k] - source[s * columns + k];
      for (auto i = s * bands; i < (s + 1) * bands; ++i)
        gathered[k][i] += grey.colour[i] * sent_on - input.mean[i];
    }
  });
  return true;
}

}  // namespace

std::vector<float> mean_of(std::span<const std::vector<float>> replicates, const Context& context) {
  assert(!replicates.empty());
  std::vector<float> mean(replicates[0].size());
  const auto fraction = 1.0f / static_cast<float>(replicates.size());
  for_all(mean.size(), context, [&](std::size_t i) {
    float sum = 0.0f;
    for (const auto& v : replicates) sum += v[i];
    mean[i] = fraction * sum;
  });
  return mean;
}

std::vector<float> dark_but_for_sky(const HitStore& hits, const PatchSet& patches) {
  const auto bands = patches.band_count();
  const auto rows = hits.sides().size();
  std::vector<float> radiosity((rows + hits.elements()) * bands, 0.0f);
  for (std::size_t p = 0; p < hits.sky_patches(); ++p)
    for (std::size_t b = 0; b < bands; ++b)
      radiosity[(rows + hits.escaped(p)) * bands + b] = static_cast<float>(patches.sky_radiosity(p, b));
  for (std::size_t p = 0; p < hits.sky_patches(); ++p)
    for (std::size_t t = 0; t < hits.tints(); ++t)
      for (std::size_t b = 0; b < bands; ++b) {
        const auto element = hits.tinted(p, t);
        radiosity[(rows + element) * bands + b] =
            static_cast<float>(hits.tint_of(element, b) * patches.sky_radiosity(p, b));
      }
  return radiosity;
}

ReplicateLight solve_replicates(const SampledOperator& transport, std::span<const std::vector<float>> direct,
                                const Scattering& scattering, std::span<float> radiosity, double tolerance,
                                const Context& context) {
  assert(tolerance > 0.0 && direct.size() == transport.hits().replicates());
  const auto count = scattering.reflectance.size();
  const auto bands = radiosity.size() / (transport.sides().size() + transport.elements());
  const auto mean_direct = mean_of(direct, context);
  const CrossedHalves crossed(transport, bands);
  std::vector<float> irradiance(2 * count);
  const auto both = repeated_twice(scattering);
  ReplicateLight light;
  light.iteration = gauss_seidel(crossed, {twice(mean_direct), both, radiosity, irradiance},
                                 {.tolerance = tolerance, .parts = 2}, context);
  light.is_stopped = light.iteration.is_stopped;
  if (light.is_stopped) return light;
  for (std::size_t half = 0; half < 2; ++half)
    for (auto& row : transport.replicate_rows(half, crossed.seen_by(half, radiosity), context)) {
      transport.hits().all_gather_receivers(row, bands);
      light.gathered.push_back(std::move(row));
    }
  // The mean of all replicates: the mean of one half would hide the noise that the half has in common.
  const auto mean = mean_of(light.gathered, context);
  for (std::size_t half = 0; half < 2 && !light.is_stopped; ++half) {
    const auto first = transport.half_begin(half);
    const auto count_of_half = transport.half_begin(half + 1) - first;
    light.is_stopped = !add_influences(transport, half,
                                       {direct.subspan(first, count_of_half), mean_direct, scattering, mean},
                                       std::span(light.gathered).subspan(first, count_of_half), context);
  }
  if (light.is_stopped) return light;
  const auto middle = mean_of(light.gathered, context);
  for_all(count, context, [&](std::size_t i) {
    const auto shift = 0.5f * (irradiance[i] + irradiance[count + i]) - mean_direct[i] - middle[i];
    for (auto& g : light.gathered) g[i] += shift;
  });
  return light;
}

}  // namespace luxel
