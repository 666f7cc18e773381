// SPDX-License-Identifier: Apache-2.0
#include "support/error_bars.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace luxel::truth {
namespace {

constexpr double nothing = 1e-9;  // of the brightest: rounding in the truth's shadows, not light

Measured mean_and_error(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double mean = 0.0;
  for (const auto v : values) mean += v / n;
  double square = 0.0;
  for (const auto v : values) square += (v - mean) * (v - mean);
  return {mean, std::sqrt(square / (n - 1.0) / n)};
}

// body(area, truth, index, back) for every side and band, lit or not.
template <typename Body>
void for_each_number(const KnownRoom& room, const Body& body) {
  const auto bands = room.patches.band_count();
  for (const bool back : {false, true}) {
    const auto& truth = room.truth.irradiance.of(back);
    for (std::size_t i = 0; i < truth.size(); ++i) body(room.patches.area[i / bands], truth[i], i, back);
  }
}

double light(const Solution& run, std::size_t i, bool back) {
  return back ? run.irradiance.back[i] : run.irradiance.front[i];
}

double stated(const Solution& run, std::size_t i, bool back) {
  const auto& errors = run.standard_error.of(back);
  return errors.empty() ? 0.0 : errors[i];
}

double coverage(const KnownRoom& room, const Solution& run) {
  double held = 0.0;
  double lit = 0.0;
  double brightest = 0.0;
  for_each_number(room,
                  [&](double, double truth, std::size_t, bool) { brightest = std::max(brightest, truth); });
  for_each_number(room, [&](double, double truth, std::size_t i, bool back) {
    if (truth <= nothing * brightest) return;
    const auto slack = (room.truth_error + 1e-6) * truth;  // H is a float
    lit += 1.0;
    if (std::abs(light(run, i, back) - truth) <= 1.96 * stated(run, i, back) + slack) held += 1.0;
  });
  return held / lit;
}

double relative_bias(const KnownRoom& room, const Solution& run) {
  double difference = 0.0;
  double whole = 0.0;
  for_each_number(room, [&](double area, double truth, std::size_t i, bool back) {
    difference += area * (light(run, i, back) - truth);
    whole += area * truth;
  });
  return difference / whole;
}

// Sum of A (H - truth) (H' - truth) over sum of A truth².
double product_of_errors(const KnownRoom& room, const Solution& run, const Solution& other) {
  double product = 0.0;
  double square = 0.0;
  for_each_number(room, [&](double area, double truth, std::size_t i, bool back) {
    product += area * (light(run, i, back) - truth) * (light(other, i, back) - truth);
    square += area * truth * truth;
  });
  return product / square;
}

}  // namespace

double true_error(const KnownRoom& room, const Solution& run) {
  return std::sqrt(product_of_errors(room, run, run));
}

double stated_error(const KnownRoom& room, const Solution& run) {
  double variance = 0.0;
  double square = 0.0;
  for_each_number(room, [&](double area, double, std::size_t i, bool back) {
    variance += area * stated(run, i, back) * stated(run, i, back);
    square += area * light(run, i, back) * light(run, i, back);
  });
  return square > 0.0 ? std::sqrt(variance / square) : 0.0;
}

ErrorBarVerdict judge(const KnownRoom& room, std::span<const Solution> runs) {
  std::vector<double> held, bias, true_square, predicted_square, product;
  for (std::size_t s = 0; s < runs.size(); ++s) {
    held.push_back(coverage(room, runs[s]));
    bias.push_back(relative_bias(room, runs[s]));
    true_square.push_back(product_of_errors(room, runs[s], runs[s]));
    predicted_square.push_back(runs[s].predicted_error * runs[s].predicted_error);
    if (s % 2 == 1) product.push_back(product_of_errors(room, runs[s - 1], runs[s]));
  }
  ErrorBarVerdict verdict;
  verdict.coverage = mean_and_error(held);
  verdict.bias = mean_and_error(bias);

  const auto square = mean_and_error(true_square).value;
  const auto predicted = mean_and_error(predicted_square).value;
  std::vector<double> lean;  // first order in the two means
  for (std::size_t s = 0; s < runs.size(); ++s)
    lean.push_back(true_square[s] / square - predicted_square[s] / predicted);
  verdict.ratio.value = std::sqrt(square / predicted);
  verdict.ratio.standard_error = 0.5 * verdict.ratio.value * mean_and_error(lean).standard_error;

  const auto shared = mean_and_error(product);
  verdict.local_bias = {shared.value / square, shared.standard_error / square};
  return verdict;
}

}  // namespace luxel::truth
