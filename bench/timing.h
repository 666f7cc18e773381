// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

#include "luxel/core/process_usage.h"

namespace luxel::bench {

template <typename Body>
double seconds(Body body) {
  const auto begin = std::chrono::steady_clock::now();
  body();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct Cost {
  double cpu = 0.0;   // s, all threads together
  double wall = 0.0;  // s
};
template <typename Body>
Cost cost(Body body) {
  const auto begin = processor_seconds();
  const auto wall = seconds(body);
  return {processor_seconds() - begin, wall};
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Ratios of two bodies' times, measured in turn (A B A B ...), so that a noisy machine disturbs both alike:
// median, minimum and maximum of time(A) / time(B).
struct Ratio {
  double median = 0.0, low = 0.0, high = 0.0;
};
template <typename A, typename B>
Ratio paired(int pairs, A a, B b) {
  std::vector<double> ratios;
  for (int i = 0; i < pairs; ++i) {
    const auto time_a = seconds(a);
    ratios.push_back(time_a / seconds(b));
  }
  const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
  return {median(ratios), *low, *high};
}

}  // namespace luxel::bench
