// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/spectrum.h"

#include <algorithm>

namespace luxel {

Spectrum::Spectrum(double first, double step, const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    samples_.push_back({first + step * static_cast<double>(i), values[i]});
}

double Spectrum::at(double wavelength, Beyond beyond) const {
  const auto next = std::lower_bound(samples_.begin(), samples_.end(), wavelength,
                                     [](const Sample& s, double w) { return s.wavelength < w; });
  if (next != samples_.end() && next->wavelength == wavelength) return next->value;
  if (next == samples_.begin()) return beyond == Beyond::holds ? samples_.front().value : 0.0;
  if (next == samples_.end()) return beyond == Beyond::holds ? samples_.back().value : 0.0;
  const auto last = next - 1;
  const auto fraction = (wavelength - last->wavelength) / (next->wavelength - last->wavelength);
  return last->value + fraction * (next->value - last->value);
}

bool Spectrum::any_above_zero() const {
  return std::any_of(samples_.begin(), samples_.end(), [](const Sample& s) { return s.value > 0.0; });
}

}  // namespace luxel
