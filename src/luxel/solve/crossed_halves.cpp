// SPDX-License-Identifier: Apache-2.0
// The two halves of a sampled operator as one system.
#include <algorithm>

#include "luxel/solve/sampled_operator.h"

namespace luxel {

CrossedHalves::CrossedHalves(const SampledOperator& whole, std::size_t bands)
    : whole_(whole),
      bands_(bands),
      row_begins_{0, static_cast<std::uint32_t>(whole.sides().size()),
                  static_cast<std::uint32_t>(2 * whole.sides().size())} {}

std::vector<float> CrossedHalves::seen_by(std::size_t half, std::span<const float> radiosity) const {
  const auto receivers = whole_.sides().size() * bands_;
  std::vector<float> seen(whole_.elements() * bands_);
  const auto other = radiosity.subspan(half == 0 ? receivers : 0, receivers);
  const auto sinks = radiosity.subspan(2 * receivers, seen.size() - receivers);
  std::copy(sinks.begin(), sinks.end(), std::copy(other.begin(), other.end(), seen.begin()));
  return seen;
}

void CrossedHalves::apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t begin,
                          std::size_t end, const Workers& workers) const {
  const auto receivers = whole_.sides().size();
  for (std::size_t half = 0; half < 2; ++half)
    if (begin <= half * receivers && (half + 1) * receivers <= end && receivers > 0)
      whole_.apply(half, bands_, seen_by(half, radiosity),
                   irradiance.subspan(half * receivers * bands_, receivers * bands_), workers);
}

}  // namespace luxel
