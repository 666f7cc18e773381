// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace luxel {

// Sampling of one point until its error is small enough: independent replicates of scrambled Sobol points,
// doubled between tests.

inline constexpr std::uint32_t gather_replicates = 8;
inline constexpr std::uint32_t first_gather_samples = 4;  // per replicate

// Calls sample(replicate, i) for samples i = 0, 1, ... of all replicates, and after each doubling
// is_enough(samples per replicate), until that is true or the next doubling exceeds max_samples of all
// replicates together. Returns the samples per replicate.
template <typename Sample, typename IsEnough>
std::uint32_t double_samples(std::uint32_t max_samples, Sample sample, IsEnough is_enough) {
  for (std::uint32_t from = 0, to = first_gather_samples;; from = to, to *= 2) {
    for (std::uint32_t r = 0; r < gather_replicates; ++r)
      for (auto i = from; i < to; ++i) sample(r, i);
    if (is_enough(to) || 2 * std::uint64_t{to} * gather_replicates > max_samples) return to;
  }
}

// The variance by which such a loop stops. Stopping where the spread happens to be small would underestimate
// errors: the spread of the first half of the samples has the same weight.
template <typename Value>
class DoubledVariance {
 public:
  // variance: of the mean of all samples, one call per doubling.
  Value of(const Value& variance) {
    const auto of_half = before_;
    before_ = variance;
    const bool is_first = passes_++ == 0;
    return is_first ? variance : 0.5 * (variance + 0.5 * of_half);
  }

 private:
  Value before_{};
  std::uint32_t passes_ = 0;
};

}  // namespace luxel
