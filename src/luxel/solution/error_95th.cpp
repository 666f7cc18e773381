// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/error_95th.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "luxel/core/percentile.h"

namespace luxel {
namespace {

constexpr double lit = 1e-3;  // of the mean irradiance

double squared_sum(const float* numbers, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    sum += static_cast<double>(numbers[i]) * static_cast<double>(numbers[i]);
  return sum;
}

}  // namespace

double error_95th_of(const Solution& solution) {
  const auto bands = solution.bands.size();
  const auto& front = solution.irradiance.front;
  const auto& back = solution.irradiance.back;
  if (solution.standard_error.front.empty() || front.empty()) return 0.0;
  double light = 0.0;
  for (const auto* of : {&front, &back})
    for (std::size_t i = 0; i < of->size(); i += bands)
      light += std::sqrt(squared_sum(of->data() + i, bands));
  const auto least =
      lit * light * static_cast<double>(bands) / static_cast<double>(front.size() + back.size());

  std::vector<float> relative;
  const auto add = [&](const std::vector<float>& irradiance, const std::vector<float>& standard_error) {
    for (std::size_t i = 0; i < irradiance.size(); i += bands) {
      const auto squared_light = squared_sum(irradiance.data() + i, bands);
      if (squared_light <= least * least) continue;
      relative.push_back(
          static_cast<float>(std::sqrt(squared_sum(standard_error.data() + i, bands) / squared_light)));
    }
  };
  add(front, solution.standard_error.front);
  add(back, solution.standard_error.back);
  if (relative.empty()) return 0.0;
  return static_cast<double>(percentile(std::move(relative), 0.95));
}

}  // namespace luxel
