// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamp_tally.h"

namespace luxel {
namespace {

// Weight of the visibility over all lamps in that of one lamp, in samples. With 1, errors are 1 to 4 %
// smaller, but the replicates depend on each other so much that their spread is 10 % too small. With very
// large values, errors are a quarter larger where there are a dozen lamps.
constexpr double prior_samples = 3.0;

}  // namespace

void add_to_tally(const LampTerm& term, std::size_t place, std::span<LampTally> tally,
                  std::span<double> seen_of_band) {
  tally[place] += {term.given, term.given * term.seen};
  if (seen_of_band.empty() || !(term.seen > 0.0)) return;
  const auto bands = seen_of_band.size() / tally.size();
  for (std::size_t b = 0; b < bands; ++b)
    seen_of_band[place * bands + b] += term.given * in_band(term.of_band, b);
}

void add_radiance(double* sum, double value, const Lamps& lamps, std::uint32_t lamp) {
  const auto radiance = lamps.radiance(lamp);
  auto* out = sum + lamps.group(lamp) * radiance.size();
  for (std::size_t b = 0; b < radiance.size(); ++b) out[b] += value * static_cast<double>(radiance[b]);
}

void add_sample(double* sum, const LampTerm& term, double per_sample, const Lamps& lamps) {
  const auto value = term.value() * per_sample;
  const auto radiance = lamps.radiance(term.lamp);
  auto* out = sum + lamps.group(term.lamp) * radiance.size();
  for (std::size_t b = 0; b < radiance.size(); ++b)
    out[b] += value * in_band(term.of_band, b) * static_cast<double>(radiance[b]);
}

void add_sky_difference(double* sum, const LampTerm& term, double per_sample, const Lamps& lamps) {
  if (!lamps.triangles()[term.lamp].is_portal()) return;
  const auto value = term.value() * per_sample;
  const auto difference = lamps.sky_difference(term.sky_patch);
  auto* out = sum + lamps.group(term.lamp) * lamps.bands();
  for (std::size_t b = 0; b < difference.size(); ++b)
    out[b] += value * in_band(term.of_band, b) * static_cast<double>(difference[b]);
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

// The tint that the other replicates found, times the estimate for all bands, and this replicate's deviation
// from that.
void LampEstimates::add_tinted(const TalliedLamps& samples, std::uint32_t replicate, std::size_t lamp,
                               double* sum) const {
  const auto known = samples.irradiance.size(), bands = samples.lamps.bands();
  const auto triangle = samples.choices.lamps()[lamp].lamp;
  const auto radiance = samples.lamps.radiance(triangle);
  const auto own_seen = samples.tally[replicate * known + lamp].seen;
  const auto others_seen = others_[lamp].seen;
  auto* out = sum + samples.lamps.group(triangle) * bands;
  for (std::size_t b = 0; b < bands; ++b) {
    const auto own = samples.seen_of_band[(replicate * known + lamp) * bands + b];
    const auto others = whole_of_band_[lamp * bands + b] - (samples.replicates > 1 ? own : 0.0);
    const auto tint = others_seen > 0.0 ? others / others_seen : 1.0;
    out[b] += (tint * value_[lamp] + (own - tint * own_seen) * samples.per_sample) *
              static_cast<double>(radiance[b]);
  }
}

void LampEstimates::add(const TalliedLamps& samples, bool control_variate, std::span<double> sum) {
  const auto known = samples.irradiance.size();
  const auto width = samples.lamps.groups() * samples.lamps.bands();
  whole_.assign(known, {});
  for (std::size_t i = 0; i < samples.tally.size(); ++i) whole_[i % known] += samples.tally[i];
  others_ = whole_;
  value_.resize(known);
  const bool is_tinted = !samples.seen_of_band.empty();
  if (is_tinted) {
    const auto width_of_band = known * samples.lamps.bands();
    whole_of_band_.assign(width_of_band, 0.0);
    for (std::size_t i = 0; i < samples.seen_of_band.size(); ++i)
      whole_of_band_[i % width_of_band] += samples.seen_of_band[i];
  }
  for (std::uint32_t r = 0; r < samples.replicates; ++r) {
    const auto own = samples.tally.subspan(r * known, known);
    for (std::size_t i = 0; i < known; ++i) {
      value_[i] = own[i].seen * samples.per_sample;
      if (samples.replicates > 1) others_[i] = whole_[i] - own[i];
    }
    if (control_variate) correct(samples, own);
    for (std::size_t i = 0; i < known; ++i) {
      if (is_tinted)
        add_tinted(samples, r, i, &sum[r * width]);
      else
        add_radiance(&sum[r * width], value_[i], samples.lamps, samples.choices.lamps()[i].lamp);
    }
  }
}

}  // namespace luxel
