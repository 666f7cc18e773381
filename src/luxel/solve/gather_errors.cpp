// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/gather_errors.h"

#include <algorithm>

namespace luxel {
namespace {

// Of the worth of a ray, what every side has, whatever it sees: rays find what none has found yet.
constexpr double even_part = 0.05;

// Calls body(first receiver, end receiver) for each unit.
template <typename Body>
void for_units(std::span<const std::uint32_t> begins, const Workers& workers, Body body) {
  workers.for_chunks(begins.size() - 1, 64, [&](std::size_t first, std::size_t end, int) {
    for (auto u = first; u < end; ++u) body(begins[u], begins[u + 1]);
  });
}

}  // namespace

std::vector<double> gather_errors(const PatchSet& patches, const SampledOperator& transport,
                                  std::span<const std::uint32_t> begins, std::span<const double> importance,
                                  std::span<const float> radiosity, std::span<const float> gathered,
                                  double whole, const Workers& workers) {
  const auto receivers = transport.sides().size();
  const auto bands = patches.band_count();
  const auto area = [&](std::size_t s) {
    return static_cast<double>(patches.area[transport.sides().side[s] / 2]);
  };

  // 1. What rows gather, in the mean of each unit; and radiosities, the mean of both halves.
  std::vector<float> level(receivers * bands);
  for_units(begins, workers, [&](std::size_t first, std::size_t end) {
    for (std::size_t b = 0; b < bands; ++b) {
      double sum = 0.0;
      double areas = 0.0;
      for (auto s = first; s < end; ++s) {
        sum += area(s) * static_cast<double>(gathered[s * bands + b]);
        areas += area(s);
      }
      for (auto s = first; s < end; ++s) level[s * bands + b] = static_cast<float>(sum / areas);
    }
  });
  const CrossedHalves crossed(transport, bands);
  auto seen = crossed.seen_by(0, radiosity);
  const auto other = crossed.seen_by(1, radiosity);
  for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = 0.5f * (seen[i] + other[i]);

  // 2. What a ray is worth. To its own row it is noisy, so neighbours take the mean, apart from their own
  // importance and number of rays.
  auto worth = transport.ray_worth(importance, seen, level, workers);
  const auto rays = [&](std::size_t s) {
    return static_cast<double>(transport.hits().rays_per_receiver()[s]);
  };
  for_units(begins, workers, [&](std::size_t first, std::size_t end) {
    double sum = 0.0;
    double areas = 0.0;
    for (auto s = first; s < end; ++s) {
      if (!(importance[s] > 0.0)) continue;
      sum += area(s) * static_cast<double>(worth.own[s]) / importance[s] * rays(s) * rays(s);
      areas += area(s);
    }
    for (auto s = first; s < end; ++s)
      worth.own[s] =
          areas > 0.0 ? static_cast<float>(sum / areas * importance[s] / (rays(s) * rays(s))) : 0.0f;
  });

  // 3. Times the density of rays.
  std::vector<double> squared_error(receivers);
  double densities = 0.0;
  double sum = 0.0;
  for (std::size_t s = 0; s < receivers; ++s) {
    const auto density = rays(s) / area(s);
    squared_error[s] = density * (static_cast<double>(worth.own[s]) + static_cast<double>(worth.given[s]));
    densities += density;
    sum += squared_error[s];
  }
  if (!(sum > 0.0)) return squared_error;
  for (std::size_t s = 0; s < receivers; ++s) {
    const auto density = rays(s) / area(s);
    squared_error[s] = whole * ((1.0 - even_part) * squared_error[s] / sum + even_part * density / densities);
  }
  return squared_error;
}

}  // namespace luxel
