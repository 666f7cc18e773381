// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace luxel {

// A number and an interval that contains its true value with a probability of at least 95 %; without errors
// both ends are the value.
struct Figure {
  double value = 0.0, low = 0.0, high = 0.0;
  // Parts of the variances behind both ends that come from sampling, which more rays reduce; the rest is the
  // error of the solution.
  double low_sampling = 1.0, high_sampling = 1.0;
};

// Values at the points of a grid with their errors. Standard errors are not widened.
struct GridSamples {
  std::vector<double> value;                    // [point]
  std::vector<double> sampling_error;           // [point], independent of each other
  double sampling_freedom = 7.0;                // degrees of freedom of each
  std::vector<std::vector<double>> replicates;  // [replicate of the solution][point]; may be empty
  std::vector<double> solution_error;           // [point], used without replicates: upper bounds
  double solution_freedom = 0.0;                // degrees of freedom; 0: none, they are taken as exact

  std::size_t size() const { return value.size(); }
  GridSamples scaled(double factor) const;
};

// Mean, extremes and uniformities of the points of a grid, with intervals of 95 %.
//
// Errors. Sampling errors s of points are independent. The solution's error is common to all: with the
// solution's replicates, the error of any linear combination of points is the spread of this combination over
// replicates; without them it is bounded by adding the points' errors as if they had the same sign. The two
// variances add, with degrees of freedom by Welch and Satterthwaite, rounded down.
//
// Minimum: each point may be the true one. With errors s_i it lies between min(e_i - t s_i) and min(e_i + t'
// s_i); t is Student's for a tail of 2.5 %, t' for 2.5 % over the number of points (Bonferroni). The low end
// needs no such correction: the true minimum lies at some point, whose own low end exceeds it with a
// probability of 2.5 %, and the minimum over points is not larger (Berger 1982). The high end is below the
// true minimum only if some point's is below its own value. Both hold for any dependence between points. The
// observed minimum itself is biased towards darkness by noise. Maximum: the same for the negatives.
//
// min_over_mean: the minimum over points of e_i / mean, each with the standard error of e_i - r mean (delta
// method), so that errors that points have in common cancel. min_over_max: from the ends of both intervals,
// each for half of the risk.
class GridFigures {
 public:
  // Keeps a reference; at least one point.
  explicit GridFigures(const GridSamples& samples);

  Figure mean() const { return mean(risk); }
  Figure min() const { return min(risk); }
  Figure max() const { return max(risk); }
  Figure min_over_mean() const;
  Figure min_over_max() const;
  Figure max_over_min() const;  // infinite where the minimum is 0

  static constexpr double risk = 0.05;  // of an interval, half of it at each end

 private:
  struct Error {
    double sampling = 0.0, solution = 0.0;  // variances
    double freedom = 0.0;

    double standard() const;
    double sampling_part() const;
  };
  Error error_of(double sampling, double sampling_freedom, double solution) const;
  double replicate_variance(const std::function<double(std::size_t replicate)>& value) const;
  Error error_of_point(std::size_t i) const;
  Error error_of_ratio(std::size_t i, double mean) const;
  Figure mean(double risk_here) const;
  Figure min(double risk_here) const;
  Figure max(double risk_here) const;
  Figure minimum(const std::function<double(std::size_t)>& value,
                 const std::function<Error(std::size_t)>& error, double risk_here) const;

  const GridSamples& samples_;
  double n_;
  double mean_ = 0.0, mean_sampling_ = 0.0, mean_freedom_ = 0.0;  // value, variance, its degrees of freedom
  double mean_bound_ = 0.0;                                       // mean of the solution errors
  std::vector<double> replicate_mean_;
};

// The ratio of two figures, each of half of the risk.
Figure ratio_of(const Figure& a, const Figure& b);

}  // namespace luxel
