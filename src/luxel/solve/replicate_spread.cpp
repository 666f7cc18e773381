// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/replicate_spread.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

constexpr std::size_t grain = 4096;  // slots a chunk

// The 97.5 % point of Student's t over that of the normal distribution (Cornish and Fisher 1938).
double student_widening(double freedom) {
  return 1.0 + (2.37 / freedom + 2.82 / (freedom * freedom) + 2.6 / (freedom * freedom * freedom)) / 1.96;
}

}  // namespace

Spread spread_of(std::span<const std::vector<float>> values, std::span<const float> bias, std::size_t bands,
                 const std::function<double(std::size_t slot)>& area, const Workers& workers) {
  const auto slots = bias.size() / bands;
  const auto n = static_cast<double>(values.size());
  const auto widening = student_widening(n - 1.0);
  Spread result;
  result.mean.resize(bias.size());
  result.standard_error.resize(bias.size());
  result.error2_of.assign(slots, 0.0);
  struct Sums {
    double error2 = 0.0, light2 = 0.0;
  };
  std::vector<Sums> sums((slots + grain - 1) / grain);
  std::vector<float> relative(slots, 0.0f);
  workers.for_chunks(slots, grain, [&](std::size_t begin, std::size_t end, int) {
    auto& chunk = sums[begin / grain];
    for (auto s = begin; s < end; ++s) {
      double light = 0.0;
      double error = 0.0;
      for (auto i = s * bands; i < (s + 1) * bands; ++i) {
        double sum = 0.0;
        for (const auto& v : values) sum += static_cast<double>(v[i]);
        const auto mean = sum / n;
        double squares = 0.0;
        for (const auto& v : values)
          squares += (static_cast<double>(v[i]) - mean) * (static_cast<double>(v[i]) - mean);
        const auto variance = squares / (n * (n - 1.0));
        result.error2_of[s] += area(s) * (variance + static_cast<double>(bias[i]));
        chunk.light2 += area(s) * mean * mean;
        const auto wide = widening * std::sqrt(variance + std::max(0.0, static_cast<double>(bias[i])));
        result.mean[i] = static_cast<float>(mean);
        result.standard_error[i] = static_cast<float>(wide);
        light += mean * mean;
        error += wide * wide;
      }
      chunk.error2 += result.error2_of[s];
      if (light > 0.0) relative[s] = static_cast<float>(std::sqrt(error / light));
    }
  });
  for (const auto& c : sums) {
    result.error2 += c.error2;
    result.light2 += c.light2;
  }
  std::erase_if(relative, [](float x) { return x == 0.0f; });
  if (!relative.empty()) {
    const auto at =
        relative.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(relative.size() - 1));
    std::nth_element(relative.begin(), at, relative.end());
    result.percentile_95 = *at;
  }
  return result;
}

}  // namespace luxel
