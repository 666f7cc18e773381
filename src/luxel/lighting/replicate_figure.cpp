// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/replicate_figure.h"

#include <cmath>

#include "luxel/core/student.h"

namespace luxel {

Figure jackknifed(double of_all, std::span<const double> left_out) {
  const auto n = static_cast<double>(left_out.size());
  // From the first on, so that equal numbers have no spread by rounding.
  const auto first = left_out.empty() ? 0.0 : left_out[0];
  double mean = 0.0, sum = 0.0;
  for (const auto v : left_out) mean += (v - first) / n;
  for (const auto v : left_out) sum += (v - first - mean) * (v - first - mean);
  const auto half = 1.96 * student_widening(n - 1.0) * std::sqrt((n - 1.0) / n * sum);
  return {of_all, of_all - half, of_all + half};
}

std::vector<float> mean_without(const std::vector<std::vector<float>>& replicates, std::size_t left_out) {
  std::vector<float> mean(replicates[0].size(), 0.0f);
  const auto count = replicates.size() - (left_out < replicates.size() ? 1 : 0);
  const auto fraction = 1.0f / static_cast<float>(count);
  for (std::size_t r = 0; r < replicates.size(); ++r)
    for (std::size_t i = 0; r != left_out && i < mean.size(); ++i) mean[i] += fraction * replicates[r][i];
  return mean;
}

Figure jackknifed(const std::vector<std::vector<float>>& replicates, const Statistic& statistic) {
  std::vector<double> left_out;
  for (std::size_t r = 0; r < replicates.size(); ++r)
    left_out.push_back(statistic(mean_without(replicates, r)));
  return jackknifed(statistic(mean_without(replicates, replicates.size())), left_out);
}

}  // namespace luxel
