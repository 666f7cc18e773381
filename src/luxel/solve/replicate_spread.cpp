// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/replicate_spread.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "luxel/core/student.h"
#include "luxel/solve/tuning.h"

namespace luxel {
namespace {

using namespace tuning::spread;

// Mean and variance of the mean over replicates, of a block of numbers.
class Block {
 public:
  explicit Block(std::size_t bands)
      : receivers_(std::max<std::size_t>(1, block_numbers / bands)), bands_(bands) {
    mean_.resize(receivers_ * bands);
    variance_.resize(receivers_ * bands);
  }
  std::size_t receivers() const { return receivers_; }
  double mean(std::size_t i) const { return mean_[i]; }
  double variance(std::size_t i) const { return variance_[i]; }

  void take(Replicates values, std::size_t first_receiver, std::size_t count) {
    take(values.size(), count * bands_, [&](std::size_t r) {
      return [v = values[r].data() + first_receiver * bands_](std::size_t i) {
        return static_cast<double>(v[i]);
      };
    });
  }
  void take_sum(Replicates first, Replicates second, std::size_t first_receiver, std::size_t count) {
    take(first.size(), count * bands_, [&](std::size_t r) {
      return [a = first[r].data() + first_receiver * bands_, b = second[r].data() + first_receiver * bands_](
                 std::size_t i) { return static_cast<double>(a[i] + b[i]); };
    });
  }

 private:
  // of_replicate(r)(i): number i of replicate r.
  template <typename OfReplicate>
  void take(std::size_t replicates, std::size_t count, OfReplicate of_replicate) {
    const auto n = static_cast<double>(replicates);
    auto* mean = mean_.data();
    auto* variance = variance_.data();
    std::fill_n(mean, count, 0.0);
    std::fill_n(variance, count, 0.0);
    for (std::size_t r = 0; r < replicates; ++r) {
      const auto value = of_replicate(r);
      for (std::size_t i = 0; i < count; ++i) mean[i] += value(i);
    }
    for (std::size_t i = 0; i < count; ++i) mean[i] *= 1.0 / n;
    for (std::size_t r = 0; r < replicates; ++r) {
      const auto value = of_replicate(r);
      for (std::size_t i = 0; i < count; ++i) variance[i] += (value(i) - mean[i]) * (value(i) - mean[i]);
    }
    for (std::size_t i = 0; i < count; ++i) variance[i] *= 1.0 / (n * (n - 1.0));
  }

  std::size_t receivers_, bands_;
  std::vector<double> mean_, variance_;
};

// take(block, first receiver, receivers): reads the replicates.
template <typename Take>
Spread spread(std::size_t replicates, const SpreadInput& input, const Context& context, Take take) {
  const auto bias = input.bias, area = input.area;
  const auto bands = input.bands;
  assert(replicates > input.constraints);
  assert(bias.size() == area.size() * bands);
  const auto receivers = area.size();
  Spread result;
  result.degrees_of_freedom = static_cast<double>(replicates - input.constraints);
  const auto widening = student_widening(result.degrees_of_freedom);
  result.mean.resize(bias.size());
  result.standard_error.resize(bias.size());
  result.squared_error.resize(bias.size());
  struct Sums {
    double variance = 0.0, total_squared_bias = 0.0, total_squared_light = 0.0;
  };
  const auto mine = spread_partition(SharedWork(context), receivers);
  const auto grain = mine.grain();
  std::vector<Sums> sums((receivers + grain - 1) / grain);
  context.for_chunks(mine.end() - mine.begin(), grain, [&](std::size_t from, std::size_t to, int) {
    const auto begin = mine.begin() + from;
    const auto end = mine.begin() + to;
    Sums chunk;
    Block block(bands);
    for (auto first = begin; first < end; first += block.receivers()) {
      const auto count = std::min(block.receivers(), end - first);
      take(block, first, count);
      for (auto s = first; s < first + count; ++s) {
        double light = 0.0;
        double variance_sum = 0.0;
        double bias_sum = 0.0;
        for (std::size_t b = 0; b < bands; ++b) {
          const auto i = s * bands + b;
          const auto mean = block.mean(i - first * bands);
          const auto variance = block.variance(i - first * bands);
          const auto squared_bias = static_cast<double>(bias[i]);
          const auto squared_error = widening * widening * (variance + std::max(0.0, squared_bias));
          result.mean[i] = static_cast<float>(mean);
          result.standard_error[i] = static_cast<float>(std::sqrt(squared_error));
          result.squared_error[i] = static_cast<float>(variance + squared_bias);
          light += mean * mean;
          variance_sum += variance;
          bias_sum += squared_bias;
        }
        const auto weight = static_cast<double>(area[s]);
        chunk.variance += weight * variance_sum;
        chunk.total_squared_bias += weight * bias_sum;
        chunk.total_squared_light += weight * light;
      }
    }
    sums[begin / grain] = chunk;
  });
  mine.all_gather(std::span(result.mean), bands);
  mine.all_gather(std::span(result.standard_error), bands);
  mine.all_gather(std::span(result.squared_error), bands);
  mine.all_gather_chunks(std::span(sums));
  Sums whole;
  for (const auto& c : sums) {
    whole.variance += c.variance;
    whole.total_squared_bias += c.total_squared_bias;
    whole.total_squared_light += c.total_squared_light;
  }
  result.total_squared_bias = std::max(0.0, whole.total_squared_bias);
  result.total_squared_error = whole.variance + result.total_squared_bias;
  result.total_squared_light = whole.total_squared_light;
  return result;
}

}  // namespace

Spread spread_of(Replicates values, const SpreadInput& input, const Context& context) {
  return spread(values.size(), input, context, [&](Block& block, std::size_t receiver, std::size_t count) {
    block.take(values, receiver, count);
  });
}

Spread spread_of_sum(Replicates first, Replicates second, const SpreadInput& input, const Context& context) {
  assert(first.size() == second.size());
  return spread(first.size(), input, context, [&](Block& block, std::size_t receiver, std::size_t count) {
    block.take_sum(first, second, receiver, count);
  });
}

std::vector<double> squared_errors(Replicates values, std::size_t bands, const Context& context) {
  std::vector<double> of_receiver(values[0].size() / bands, 0.0);
  const auto mine = spread_partition(SharedWork(context), of_receiver.size());
  context.for_chunks(mine.end() - mine.begin(), mine.grain(), [&](std::size_t from, std::size_t to, int) {
    const auto begin = mine.begin() + from;
    const auto end = mine.begin() + to;
    Block block(bands);
    for (auto first = begin; first < end; first += block.receivers()) {
      const auto count = std::min(block.receivers(), end - first);
      block.take(values, first, count);
      for (std::size_t s = 0; s < count; ++s)
        for (std::size_t b = 0; b < bands; ++b) of_receiver[first + s] += block.variance(s * bands + b);
    }
  });
  mine.all_gather(std::span(of_receiver), 1);
  return of_receiver;
}

}  // namespace luxel
