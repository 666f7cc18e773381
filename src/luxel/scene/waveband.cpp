// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/spectrum.h"

namespace luxel {
namespace {

// Integral of the spectrum between the two wavelengths, weighted by a ramp from 0 at `zero` to 1 at `full`;
// either may be the lower one.
double ramp(const Spectrum& spectrum, Beyond beyond, double zero, double full) {
  const auto low = zero < full ? zero : full;
  const auto high = zero < full ? full : zero;
  const auto weight = [&](double x) { return (x - zero) / (full - zero); };
  double sum = 0.0;
  // Between samples the product is a parabola, for which Simpson's rule is exact. A spectrum jumps where it
  // ends, so its intervals are evaluated inside.
  const auto add = [&](double a, double b) {
    if (!(b > a)) return;
    const auto middle = 0.5 * (a + b);
    const auto outside = middle < spectrum.front().wavelength || middle > spectrum.back().wavelength;
    if (outside && beyond == Beyond::zero) return;
    sum += (b - a) / 6.0 *
           (weight(a) * spectrum.at(a, beyond) + 4.0 * weight(middle) * spectrum.at(middle, beyond) +
            weight(b) * spectrum.at(b, beyond));
  };
  auto from = low;
  for (const auto& sample : spectrum.samples())
    if (sample.wavelength > from && sample.wavelength < high) {
      add(from, sample.wavelength);
      from = sample.wavelength;
    }
  add(from, high);
  return sum;
}

}  // namespace

std::vector<Waveband> make_wavebands(const std::vector<double>& wavelengths) {
  std::vector<Waveband> bands;
  for (std::size_t i = 0; i < wavelengths.size(); ++i) {
    const auto before = i > 0 ? wavelengths[i - 1] : wavelengths[i];
    const auto behind = i + 1 < wavelengths.size() ? wavelengths[i + 1] : wavelengths[i];
    bands.push_back({wavelengths[i], 0.5 * (behind - before)});
  }
  return bands;
}

double mean_around(const std::vector<Waveband>& wavebands, std::size_t i, const Spectrum& spectrum,
                   Beyond beyond) {
  const auto here = wavebands[i].wavelength;
  double sum = 0.0;
  if (i > 0) sum += ramp(spectrum, beyond, wavebands[i - 1].wavelength, here);
  if (i + 1 < wavebands.size()) sum += ramp(spectrum, beyond, wavebands[i + 1].wavelength, here);
  return sum / wavebands[i].width;
}

}  // namespace luxel
