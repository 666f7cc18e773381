// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/group_sums.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace luxel {
namespace {

struct Estimate {
  double mean = 0.0, standard_error = 0.0;
};

Estimate estimate_of(std::span<const double> replicate) {
  const auto r = static_cast<double>(replicate.size());
  Estimate result;
  for (const auto value : replicate) result.mean += value;
  result.mean /= r;
  double deviations = 0.0;
  for (const auto value : replicate) deviations += (value - result.mean) * (value - result.mean);
  result.standard_error = std::sqrt(deviations / (r * (r - 1.0)));
  return result;
}

}  // namespace

std::size_t GroupSums::place_of(std::uint32_t from, std::uint32_t met) {
  const auto key = (std::uint64_t{from} << 32) | met;
  if (key == last_key_) return last_place_;
  const auto [entry, is_new] = places_.try_emplace(key, keys_.size());
  if (is_new) {
    keys_.push_back(key);
    sums_.resize(sums_.size() + replicates_, 0.0);
  }
  last_key_ = key;
  last_place_ = entry->second;
  return last_place_;
}

void GroupSums::add(const GroupSums& other) {
  for (std::size_t p = 0; p < other.keys_.size(); ++p) {
    const auto key = other.keys_[p];
    const auto place = place_of(static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key));
    for (std::uint32_t r = 0; r < replicates_; ++r)
      sums_[place * replicates_ + r] += other.sums_[p * replicates_ + r];
  }
}

void GroupSums::write(std::span<const double> whole, double min_factor, ViewFactors& factors) const {
  std::vector<std::size_t> order(keys_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [this](auto a, auto b) { return keys_[a] < keys_[b]; });

  const auto elements = static_cast<std::uint32_t>(factors.size());
  std::vector<double> fraction(replicates_), lost(replicates_, 0.0);
  std::size_t next = 0;
  for (std::uint32_t from = 0; from < elements; ++from) {
    factors.is_known[from] = whole[from] > 0.0 ? 1 : 0;
    std::fill(lost.begin(), lost.end(), 0.0);
    for (; next < order.size() && keys_[order[next]] >> 32 == from; ++next) {
      const auto met = static_cast<std::uint32_t>(keys_[order[next]]);
      for (std::uint32_t r = 0; r < replicates_; ++r)
        fraction[r] = sums_[order[next] * replicates_ + r] / whole[from];
      const auto estimate = estimate_of(fraction);
      if (met >= elements) {
        factors.sink[met - elements].factor[from] = estimate.mean;
        factors.sink[met - elements].standard_error[from] = static_cast<float>(estimate.standard_error);
      } else if (estimate.mean < min_factor) {
        for (std::uint32_t r = 0; r < replicates_; ++r) lost[r] += fraction[r];
      } else {
        factors.column.push_back(met);
        factors.factor.push_back(estimate.mean);
        factors.standard_error.push_back(static_cast<float>(estimate.standard_error));
      }
    }
    const auto dropped = estimate_of(lost);
    factors.sink[ViewFactors::dropped].factor[from] = dropped.mean;
    factors.sink[ViewFactors::dropped].standard_error[from] = static_cast<float>(dropped.standard_error);
    factors.row_begin[from + 1] = factors.count();
  }
}

double rms_standard_error(const ViewFactors& factors) {
  double sum = 0.0;
  for (const double error : factors.standard_error) sum += error * error;
  return factors.count() > 0 ? std::sqrt(sum / static_cast<double>(factors.count())) : 0.0;
}

}  // namespace luxel
