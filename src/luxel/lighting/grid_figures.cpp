// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/grid_figures.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "luxel/core/student_quantile.h"

namespace luxel {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Degrees of freedom are rounded down to one of few values, so that few quantiles are computed: each
// costs a millisecond.
double quantile(double tail, double freedom) {
  thread_local std::map<std::pair<double, double>, double> known;
  constexpr std::array<double, 8> large = {30, 40, 50, 70, 100, 200, 400, 1000};
  auto rounded = freedom > 0.0 ? std::max(1.0, std::floor(freedom)) : 0.0;
  if (rounded > large.front()) rounded = *(std::upper_bound(large.begin(), large.end(), rounded) - 1);
  const auto [place, is_new] = known.emplace(std::pair(tail, rounded), 0.0);
  if (is_new) place->second = student_quantile(tail, rounded);
  return place->second;
}

}  // namespace

GridSamples GridSamples::scaled(double factor) const {
  auto result = *this;
  const auto scale = [&](std::vector<double>& numbers) {
    for (auto& x : numbers) x *= factor;
  };
  scale(result.value);
  scale(result.sampling_error);
  scale(result.solution_error);
  for (auto& of_replicate : result.replicates) scale(of_replicate);
  return result;
}

double GridFigures::Error::standard() const { return std::sqrt(sampling + solution); }

double GridFigures::Error::sampling_part() const {
  return sampling + solution > 0.0 ? sampling / (sampling + solution) : 1.0;
}

GridFigures::GridFigures(const GridSamples& samples)
    : samples_(samples), n_(static_cast<double>(samples.size())) {
  assert(samples.size() > 0);
  double fourth = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    mean_ += samples.value[i] / n_;
    const auto variance = samples.sampling_error[i] * samples.sampling_error[i] / (n_ * n_);
    mean_sampling_ += variance;
    fourth += variance * variance / samples.sampling_freedom;
    if (!samples.solution_error.empty()) mean_bound_ += samples.solution_error[i] / n_;
  }
  mean_freedom_ = fourth > 0.0 ? mean_sampling_ * mean_sampling_ / fourth : samples.sampling_freedom;
  for (const auto& of_replicate : samples.replicates) {
    double sum = 0.0;
    for (const auto x : of_replicate) sum += x;
    replicate_mean_.push_back(sum / n_);
  }
}

double GridFigures::replicate_variance(const std::function<double(std::size_t)>& value) const {
  const auto count = samples_.replicates.size();
  const auto r = static_cast<double>(count);
  double mean = 0.0, sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) mean += value(k) / r;
  for (std::size_t k = 0; k < count; ++k) sum += (value(k) - mean) * (value(k) - mean);
  return sum / (r * (r - 1.0));
}

GridFigures::Error GridFigures::error_of(double sampling, double sampling_freedom, double solution) const {
  const auto whole = sampling + solution;
  const auto solution_freedom = samples_.replicates.empty()
                                    ? samples_.solution_freedom
                                    : static_cast<double>(samples_.replicates.size() - 1);
  const auto fourth = sampling * sampling / sampling_freedom +
                      (solution_freedom > 0.0 ? solution * solution / solution_freedom : 0.0);
  return {sampling, solution, fourth > 0.0 ? whole * whole / fourth : 0.0};
}

GridFigures::Error GridFigures::error_of_point(std::size_t i) const {
  const auto s = samples_.sampling_error[i];
  double solution = 0.0;
  if (!samples_.replicates.empty())
    solution = replicate_variance([&](std::size_t k) { return samples_.replicates[k][i]; });
  else if (!samples_.solution_error.empty())
    solution = samples_.solution_error[i] * samples_.solution_error[i];
  return error_of(s * s, samples_.sampling_freedom, solution);
}

GridFigures::Error GridFigures::error_of_ratio(std::size_t i, double mean) const {
  const auto r = samples_.value[i] / mean;
  const auto s = samples_.sampling_error[i];
  const auto sampling = std::max(0.0, s * s * (1.0 - 2.0 * r / n_) + r * r * mean_sampling_);
  double solution = 0.0;
  if (!samples_.replicates.empty()) {
    solution =
        replicate_variance([&](std::size_t k) { return samples_.replicates[k][i] - r * replicate_mean_[k]; });
  } else if (!samples_.solution_error.empty()) {
    const auto bound = samples_.solution_error[i] + r * mean_bound_;
    solution = bound * bound;
  }
  return error_of(sampling / (mean * mean), samples_.sampling_freedom, solution / (mean * mean));
}

Figure GridFigures::mean(double risk_here) const {
  double solution = 0.0;
  if (!samples_.replicates.empty())
    solution = replicate_variance([&](std::size_t k) { return replicate_mean_[k]; });
  else
    solution = mean_bound_ * mean_bound_;
  const auto error = error_of(mean_sampling_, mean_freedom_, solution);
  const auto reach =
      error.standard() > 0.0 ? quantile(0.5 * risk_here, error.freedom) * error.standard() : 0.0;
  const auto part = error.sampling_part();
  return {mean_, std::max(0.0, mean_ - reach), mean_ + reach, part, part};
}

Figure GridFigures::minimum(const std::function<double(std::size_t)>& value,
                            const std::function<Error(std::size_t)>& error, double risk_here) const {
  Figure figure{infinity, infinity, infinity};
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const auto e = value(i);
    const auto of_point = error(i);
    const auto s = of_point.standard();
    const auto one = s > 0.0 ? quantile(0.5 * risk_here, of_point.freedom) : 0.0;
    const auto all = s > 0.0 ? quantile(0.5 * risk_here / n_, of_point.freedom) : 0.0;
    figure.value = std::min(figure.value, e);
    if (e - one * s < figure.low) {
      figure.low = e - one * s;
      figure.low_sampling = of_point.sampling_part();
    }
    if (e + all * s < figure.high) {
      figure.high = e + all * s;
      figure.high_sampling = of_point.sampling_part();
    }
  }
  return figure;
}

Figure GridFigures::min(double risk_here) const {
  auto figure = minimum([&](std::size_t i) { return samples_.value[i]; },
                        [&](std::size_t i) { return error_of_point(i); }, risk_here);
  figure.low = std::max(0.0, figure.low);
  return figure;
}

Figure GridFigures::max(double risk_here) const {
  const auto negative = minimum([&](std::size_t i) { return -samples_.value[i]; },
                                [&](std::size_t i) { return error_of_point(i); }, risk_here);
  return {-negative.value, std::max(0.0, -negative.high), -negative.low, negative.high_sampling,
          negative.low_sampling};
}

Figure GridFigures::min_over_mean() const {
  if (!(mean_ > 0.0)) return {0.0, 0.0, 1.0};
  auto figure = minimum([&](std::size_t i) { return samples_.value[i] / mean_; },
                        [&](std::size_t i) { return error_of_ratio(i, mean_); }, risk);
  figure.low = std::max(0.0, figure.low);
  figure.high = std::min(1.0, figure.high);
  return figure;
}

Figure GridFigures::min_over_max() const {
  auto figure = ratio_of(min(0.5 * risk), max(0.5 * risk));
  figure.high = std::min(1.0, figure.high);
  return figure;
}

Figure GridFigures::max_over_min() const {
  auto figure = ratio_of(max(0.5 * risk), min(0.5 * risk));
  figure.low = std::max(1.0, figure.low);
  return figure;
}

Figure ratio_of(const Figure& a, const Figure& b) {
  const auto over = [](double x, double y) { return y > 0.0 ? x / y : x > 0.0 ? infinity : 0.0; };
  return {over(a.value, b.value), over(a.low, b.high), over(a.high, b.low),
          std::min(a.low_sampling, b.high_sampling), std::min(a.high_sampling, b.low_sampling)};
}

}  // namespace luxel
