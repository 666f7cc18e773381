// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/progress.h"
#include "luxel/solution/solution.h"

namespace luxel {

// Limits of a reference.
struct ReferenceLimits {
  std::uint64_t samples =
      0;                // paths per patch side, or per pixel, in whole batches; 0: until the error is reached
  double error = 0.01;  // relative RMS standard error of the whole; without `samples`
};

// Means of many elements (sides, pixels), each from independent batches of paths: the spread of an element's
// batches is the standard error of its mean. Nothing is adapted to an element: all have the same number of
// batches, unless a run is stopped.
class BatchMeans {
 public:
  // Cells of the grid over which the first vertices of a batch's paths are spread; one path per cell.
  static constexpr std::uint32_t batch_side = 4;
  static constexpr std::uint64_t batch_paths = batch_side * batch_side;

  // values: numbers per element has.
  BatchMeans(std::size_t elements, std::size_t values)
      : values_(values),
        count_(elements, 0),
        mean_(elements * values, 0.0),
        square_(elements * values, 0.0) {}

  // Adds the sum over the paths of one batch to sums, [value]; returns the rays traced. Must depend on its
  // arguments alone.
  using Draw = std::function<std::uint64_t(std::size_t element, std::uint64_t batch, std::span<double> sums)>;
  // The relative error of the whole, from all batches so far.
  using Error = std::function<double(const BatchMeans&)>;

  // Draws until the limits or the monitor stop it. The same bits on any number of threads.
  StopReason run(const ReferenceLimits& limits, const Draw& draw, const Error& error, const Context& context,
                 std::string_view stage);

  std::size_t elements() const { return count_.size(); }
  std::uint64_t batches(std::size_t element) const { return count_[element]; }
  // Returns whether each element has the two batches that an error needs.
  bool complete() const;
  double mean(std::size_t element, std::size_t value) const { return mean_[element * values_ + value]; }
  // Standard error of the mean; 0 where there are fewer than two batches.
  double variance(std::size_t element, std::size_t value) const;
  std::uint64_t rays() const { return rays_; }

 private:
  // Brings every element up to this many batches; returns false if it was stopped on the way.
  bool draw_up_to(std::uint64_t batches, const Draw& draw, const Context& context,
                  const std::function<Progress(double)>& progress);

  std::size_t values_;
  std::vector<std::uint64_t> count_;   // [element]
  std::vector<double> mean_, square_;  // [element][value]; square: sum of squared deviations
  std::uint64_t rays_ = 0;
};

// Returns the factor that widens a standard error whose variance is estimated from this few batches: the 97.5
// % point of Student's t over that of the normal distribution (Cornish and Fisher 1938).
double widening_of(std::uint64_t batches);

}  // namespace luxel
