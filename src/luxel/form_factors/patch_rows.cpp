// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/patch_rows.h"

#include <algorithm>
#include <cmath>

namespace luxel {

CountedFraction counted_fraction(std::span<const std::uint32_t> counts, std::uint64_t per_replicate) {
  std::uint64_t sum = 0, squares = 0;
  for (const std::uint64_t c : counts) {
    sum += c;
    squares += c * c;
  }
  const auto r = static_cast<double>(counts.size());
  const auto n = static_cast<double>(per_replicate);
  // (r squares - sum²) / r is the sum of squared deviations, in integers until the division.
  const auto deviations = static_cast<double>(counts.size() * squares - sum * sum) / r;
  return {static_cast<std::uint32_t>(sum), static_cast<double>(sum) / (r * n),
          std::sqrt(deviations / (r * (r - 1.0))) / n};
}

void append_patch_rows(const ElementRays& rays, std::span<const std::uint32_t> receivers,
                       std::uint32_t per_receiver, double min_factor, PatchRowScratch& scratch,
                       PatchRows& rows) {
  const auto replicates = rays.replicates();
  const auto elements = static_cast<std::uint32_t>(rays.elements().size());
  const auto run = receivers.size() * per_receiver;
  scratch.met.resize(replicates * run);
  scratch.place.resize(elements + ViewFactors::sinks, 0);
  for (std::uint32_t r = 0; r < replicates; ++r)
    rays.trace(receivers, r, 0, per_receiver, std::span(scratch.met).subspan(r * run, run));

  for (std::size_t s = 0; s < receivers.size(); ++s) {
    // 1. Count how often each number was met in each replicate.
    auto& numbers = scratch.numbers;
    auto& counts = scratch.counts;
    numbers.clear();
    counts.clear();
    for (std::uint32_t r = 0; r < replicates; ++r)
      for (const auto number : std::span(scratch.met).subspan(r * run + s * per_receiver, per_receiver)) {
        if (scratch.place[number] == 0) {
          numbers.push_back(number);
          scratch.place[number] = static_cast<std::uint32_t>(numbers.size());
          counts.resize(counts.size() + replicates, 0);
        }
        ++counts[(scratch.place[number] - 1) * replicates + r];
      }
    // 2. Convert the counts to fractions, columns ascending; sinks have the highest numbers.
    std::sort(numbers.begin(), numbers.end());
    rows.element.push_back(rays.element_of_receiver(receivers[s]));
    const auto before = rows.column.size();
    std::array<CountedFraction, ViewFactors::sinks> sink{};
    std::vector<std::uint32_t> dropped;
    for (const auto number : numbers) {
      const auto own = std::span(counts).subspan((scratch.place[number] - 1) * replicates, replicates);
      const auto fraction = counted_fraction(own, per_receiver);
      if (number >= elements) {
        sink[number - elements] = fraction;
      } else if (fraction.fraction < min_factor) {
        dropped.resize(replicates, 0);
        for (std::uint32_t r = 0; r < replicates; ++r) dropped[r] += own[r];
      } else {
        rows.column.push_back(number);
        rows.hits.push_back(fraction.hits);
        rows.standard_error.push_back(static_cast<float>(fraction.standard_error));
        rows.factor_squared_error += fraction.standard_error * fraction.standard_error;
      }
    }
    if (!dropped.empty()) sink[ViewFactors::dropped] = counted_fraction(dropped, per_receiver);
    rows.length.push_back(static_cast<std::uint32_t>(rows.column.size() - before));
    for (std::size_t k = 0; k < sink.size(); ++k) {
      rows.sink[k].push_back(sink[k].fraction);
      rows.sink_error[k].push_back(static_cast<float>(sink[k].standard_error));
    }
    for (const auto& fraction : sink)
      rows.sink_squared_error += fraction.standard_error * fraction.standard_error;
    for (const auto number : numbers) scratch.place[number] = 0;
  }
}

}  // namespace luxel
