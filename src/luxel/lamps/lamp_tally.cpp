// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamp_tally.h"

namespace luxel {
namespace {

// Weight of the visibility over all lamps in that of one lamp, in samples. With 1, errors are 1 to 4 %
// smaller, but the replicates depend on each other so much that their spread is 10 % too small. With very
// large values, errors are a quarter larger where there are a dozen lamps.
constexpr double prior_samples = 3.0;

}  // namespace

void add_radiance(double* sum, double value, const Lamps& lamps, std::uint32_t lamp) {
  const auto radiance = lamps.radiance(lamp);
  auto* out = sum + lamps.group(lamp) * radiance.size();
  for (std::size_t b = 0; b < radiance.size(); ++b) out[b] += value * static_cast<double>(radiance[b]);
}

// The estimate of one replicate for each lamp with a closed form, at unit radiance: its own visible samples,
// corrected by the visibility that other replicates found (a control variate). own: [lamp], sums of this
// replicate.
void LampEstimates::correct(const TalliedLamps& samples, std::span<const LampTally> own) {
  LampTally together;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto weight = samples.lamps.triangles()[samples.choices.lamps()[i].lamp].weight;
    together += {weight * others_[i].all, weight * others_[i].seen};
  }
  const auto visibility = together.all > 0.0 ? together.seen / together.all : 0.0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto irradiance = samples.irradiance[i];
    const auto prior = prior_samples * irradiance / samples.choices.probability(i);
    const auto all = others_[i].all + prior;
    const auto beta = all > 0.0 ? (others_[i].seen + prior * visibility) / all : visibility;
    value_[i] = beta * irradiance + (own[i].seen - beta * own[i].all) * samples.per_sample;
  }
}

void LampEstimates::add(const TalliedLamps& samples, bool control_variate, std::span<double> sum) {
  const auto known = samples.irradiance.size();
  const auto width = samples.lamps.groups() * samples.lamps.bands();
  whole_.assign(known, {});
  for (std::size_t i = 0; i < samples.tally.size(); ++i) whole_[i % known] += samples.tally[i];
  others_ = whole_;
  value_.resize(known);
  for (std::uint32_t r = 0; r < samples.replicates; ++r) {
    const auto own = samples.tally.subspan(r * known, known);
    for (std::size_t i = 0; i < known; ++i) {
      value_[i] = own[i].seen * samples.per_sample;
      if (samples.replicates > 1) others_[i] = whole_[i] - own[i];
    }
    if (control_variate) correct(samples, own);
    for (std::size_t i = 0; i < known; ++i)
      add_radiance(&sum[r * width], value_[i], samples.lamps, samples.choices.lamps()[i].lamp);
  }
}

}  // namespace luxel
