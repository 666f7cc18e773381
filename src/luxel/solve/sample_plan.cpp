// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sample_plan.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace luxel {
namespace {

constexpr double left_by_doubling = 0.45;  // of the squared error; independent points leave 0.5
constexpr int max_doublings = 4;           // at a time: an estimate of the error is only so good

}  // namespace

std::vector<std::uint8_t> plan_doublings(std::span<const SampleUnit> units, double target, double least,
                                         double budget) {
  std::vector<std::uint8_t> doublings(units.size(), 0);
  using Entry = std::tuple<double, std::size_t>;  // squared_error over cost, unit
  std::priority_queue<Entry> queue;
  double squared_error = 0.0;
  for (std::size_t u = 0; u < units.size(); ++u) {
    squared_error += units[u].squared_error;
    if (units[u].squared_error > 0.0) queue.emplace(units[u].squared_error / units[u].cost, u);
  }
  double spent = 0.0;
  while ((squared_error > target || spent < least) && !queue.empty()) {
    const auto [worth, u] = queue.top();
    queue.pop();
    if (doublings[u] == max_doublings) {
      // What remains is worth less than this one, which will be seen more clearly next time.
      if (spent >= least) break;
      continue;
    }
    double left = units[u].squared_error;
    double cost = units[u].cost;
    for (int i = 0; i < doublings[u]; ++i) {
      left *= left_by_doubling;
      cost *= 2.0;
    }
    if (spent + cost > budget) break;
    spent += cost;
    squared_error -= (1.0 - left_by_doubling) * left;
    ++doublings[u];
    queue.emplace(worth * 0.5 * left_by_doubling, u);
  }
  return doublings;
}

double expected_squared_error(std::span<const SampleUnit> units, std::span<const std::uint8_t> doublings) {
  double sum = 0.0;
  for (std::size_t u = 0; u < units.size(); ++u)
    sum += units[u].squared_error * std::pow(left_by_doubling, doublings[u]);
  return sum;
}

}  // namespace luxel
