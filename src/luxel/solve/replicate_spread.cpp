// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/replicate_spread.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "luxel/math/student.h"

namespace luxel {
namespace {

constexpr std::size_t block_numbers = 768;  // of each replicate at a time: all of them fit in the first cache
constexpr std::size_t sort_grain = 1 << 17;  // numbers a chunk
constexpr std::uint32_t bin_shift = 18;      // bits of a float left out: bins 3 % wide
constexpr std::size_t bins = std::size_t{1} << (31 - bin_shift);

// Mean and variance of the mean over replicates, of a block of numbers.
class Block {
 public:
  explicit Block(std::size_t bands) : slots_(std::max<std::size_t>(1, block_numbers / bands)), bands_(bands) {
    mean_.resize(slots_ * bands);
    variance_.resize(slots_ * bands);
  }
  std::size_t slots() const { return slots_; }
  double mean(std::size_t i) const { return mean_[i]; }
  double variance(std::size_t i) const { return variance_[i]; }

  void take(Replicates values, std::size_t first_slot, std::size_t count) {
    take(values.size(), count * bands_, [&](std::size_t r) {
      return
          [v = values[r].data() + first_slot * bands_](std::size_t i) { return static_cast<double>(v[i]); };
    });
  }
  void take_sum(Replicates first, Replicates second, std::size_t first_slot, std::size_t count) {
    take(first.size(), count * bands_, [&](std::size_t r) {
      return [a = first[r].data() + first_slot * bands_, b = second[r].data() + first_slot * bands_](
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

  std::size_t slots_, bands_;
  std::vector<double> mean_, variance_;
};

// The number that 95 in 100 of those above 0 do not exceed; 0 where there are none.
float percentile_95(std::span<const float> numbers, const Workers& workers) {
  const auto bin_of = [](float x) { return std::bit_cast<std::uint32_t>(x) >> bin_shift; };
  std::vector<std::vector<std::uint32_t>> counts((numbers.size() + sort_grain - 1) / sort_grain);
  workers.for_chunks(numbers.size(), sort_grain, [&](std::size_t begin, std::size_t end, int) {
    auto& count = counts[begin / sort_grain];
    count.assign(bins, 0);
    for (auto i = begin; i < end; ++i)
      if (numbers[i] > 0.0f) ++count[bin_of(numbers[i])];
  });
  std::vector<std::size_t> count(bins, 0);
  std::size_t all = 0;
  for (const auto& chunk : counts)
    for (std::size_t b = 0; b < bins; ++b) {
      count[b] += chunk[b];
      all += chunk[b];
    }
  if (all == 0) return 0.0f;
  auto rank = static_cast<std::size_t>(0.95 * static_cast<double>(all - 1));
  std::uint32_t bin = 0;
  while (rank >= count[bin]) rank -= count[bin++];
  std::vector<float> near;
  near.reserve(count[bin]);
  for (const auto x : numbers)
    if (x > 0.0f && bin_of(x) == bin) near.push_back(x);
  const auto at = near.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(near.begin(), at, near.end());
  return *at;
}

// take(block, first slot, slots): reads the replicates.
template <typename Take>
Spread spread(std::size_t replicates, std::span<const float> bias, std::size_t bands,
              std::span<const float> area, const Workers& workers, std::size_t constraints,
              const Ranks* ranks, Take take) {
  const auto slots = area.size();
  Spread result;
  result.freedom = static_cast<double>(replicates - constraints);
  const auto widening = student_widening(result.freedom);
  result.mean.resize(bias.size());
  result.standard_error.resize(bias.size());
  result.squared_error.resize(bias.size());
  struct Sums {
    double variance = 0.0, bias2 = 0.0, light2 = 0.0;
  };
  const auto mine = spread_share(ranks, slots);
  const auto grain = mine.grain();
  std::vector<Sums> sums((slots + grain - 1) / grain);
  std::vector<float> relative(slots, 0.0f);
  workers.for_chunks(mine.end() - mine.begin(), grain, [&](std::size_t from, std::size_t to, int) {
    const auto begin = mine.begin() + from;
    const auto end = mine.begin() + to;
    Sums chunk;
    Block block(bands);
    for (auto first = begin; first < end; first += block.slots()) {
      const auto count = std::min(block.slots(), end - first);
      take(block, first, count);
      for (auto s = first; s < first + count; ++s) {
        double light = 0.0;
        double variance_sum = 0.0;
        double bias_sum = 0.0;
        double wide = 0.0;
        for (std::size_t b = 0; b < bands; ++b) {
          const auto i = s * bands + b;
          const auto mean = block.mean(i - first * bands);
          const auto variance = block.variance(i - first * bands);
          const auto bias2 = static_cast<double>(bias[i]);
          const auto error2 = widening * widening * (variance + std::max(0.0, bias2));
          result.mean[i] = static_cast<float>(mean);
          result.standard_error[i] = static_cast<float>(std::sqrt(error2));
          result.squared_error[i] = static_cast<float>(variance + bias2);
          light += mean * mean;
          variance_sum += variance;
          bias_sum += bias2;
          wide += error2;
        }
        const auto weight = static_cast<double>(area[s]);
        chunk.variance += weight * variance_sum;
        chunk.bias2 += weight * bias_sum;
        chunk.light2 += weight * light;
        if (light > 0.0) relative[s] = static_cast<float>(std::sqrt(wide / light));
      }
    }
    sums[begin / grain] = chunk;
  });
  mine.share(std::span(result.mean), bands);
  mine.share(std::span(result.standard_error), bands);
  mine.share(std::span(result.squared_error), bands);
  mine.share(std::span(relative), 1);
  mine.share_chunks(std::span(sums));
  Sums whole;
  for (const auto& c : sums) {
    whole.variance += c.variance;
    whole.bias2 += c.bias2;
    whole.light2 += c.light2;
  }
  result.bias2 = std::max(0.0, whole.bias2);
  result.error2 = whole.variance + result.bias2;
  result.light2 = whole.light2;
  result.percentile_95 = static_cast<double>(percentile_95(relative, workers));
  return result;
}

}  // namespace

Spread spread_of(Replicates values, std::span<const float> bias, std::size_t bands,
                 std::span<const float> area, const Workers& workers, std::size_t constraints,
                 const Ranks* ranks) {
  return spread(values.size(), bias, bands, area, workers, constraints, ranks,
                [&](Block& block, std::size_t slot, std::size_t count) { block.take(values, slot, count); });
}

Spread spread_of_sum(Replicates first, Replicates second, std::span<const float> bias, std::size_t bands,
                     std::span<const float> area, const Workers& workers, std::size_t constraints,
                     const Ranks* ranks) {
  return spread(
      first.size(), bias, bands, area, workers, constraints, ranks,
      [&](Block& block, std::size_t slot, std::size_t count) { block.take_sum(first, second, slot, count); });
}

std::vector<double> squared_errors(Replicates values, std::size_t bands, const Workers& workers,
                                   const Ranks* ranks) {
  std::vector<double> of_slot(values[0].size() / bands, 0.0);
  const auto mine = spread_share(ranks, of_slot.size());
  workers.for_chunks(mine.end() - mine.begin(), mine.grain(), [&](std::size_t from, std::size_t to, int) {
    const auto begin = mine.begin() + from;
    const auto end = mine.begin() + to;
    Block block(bands);
    for (auto first = begin; first < end; first += block.slots()) {
      const auto count = std::min(block.slots(), end - first);
      block.take(values, first, count);
      for (std::size_t s = 0; s < count; ++s)
        for (std::size_t b = 0; b < bands; ++b) of_slot[first + s] += block.variance(s * bands + b);
    }
  });
  mine.share(std::span(of_slot), 1);
  return of_slot;
}

}  // namespace luxel
