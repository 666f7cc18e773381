// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sample_units.h"

#include <algorithm>
#include <numeric>

namespace luxel {

std::vector<SampleUnit> make_sample_units(const Sampling& sampling, std::uint32_t replicates,
                                          std::span<const double> importance,
                                          std::span<const double> direct_error2,
                                          std::span<const double> gathered_error2, double whole) {
  const auto begins = sampling.units();
  const auto n = begins.size() - 1;
  std::vector<SampleUnit> units(n + gathered_error2.size());
  for (std::size_t u = 0; u < n; ++u) {
    const auto count = begins[u + 1] - begins[u];
    units[u] = {weighted_sum(importance.subspan(begins[u], count), direct_error2.subspan(begins[u], count)),
                shadow_ray_cost * sampling.direct().samples_a_slot()[begins[u]] * replicates * count};
  }
  for (std::size_t s = 0; s < gathered_error2.size(); ++s)
    units[n + s] = {gathered_error2[s], static_cast<double>(sampling.hits().rays_per_slot()[s]) * replicates};
  double sum = 0.0;
  for (const auto& u : units) sum += u.error2;
  for (auto& u : units) u.error2 *= whole / std::max(sum, 1e-300);
  return units;
}

double weighted_sum(std::span<const double> weights, std::span<const double> values) {
  return std::inner_product(weights.begin(), weights.end(), values.begin(), 0.0);
}

}  // namespace luxel
