// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/deposits.h"

#include <numeric>
#include <utility>

namespace luxel {
namespace {

constexpr std::size_t cache_lines = 16;  // counters per two cache lines, which processors fetch as a pair
// counters up to which each thread has a copy: shared ones would be contended, and clearing so few costs
// nothing
constexpr std::size_t always_private = 1024;
constexpr std::size_t grain = 1 << 14;  // places per chunk

}  // namespace

Deposits::Deposits(std::size_t places, std::size_t bands, const Context& context)
    : bands_(bands),
      threads_(static_cast<std::size_t>(context.threads())),
      stride_((places * bands + cache_lines - 1) / cache_lines * cache_lines),
      counters_(stride_, 0),
      touched_(places, 0) {}

void Deposits::expect(std::uint64_t adds) {
  const auto counters = touched_.size() * bands_;
  const auto copies = counters * threads_;
  const bool fits = copies <= private_bytes / sizeof(std::int64_t);
  is_private_ = counters <= always_private || (adds > copies && fits);
  if (is_private_ && counters_.size() < threads_ * stride_) counters_.resize(threads_ * stride_, 0);
}

Deposits::Sums Deposits::take(const Context& context) {
  // 1. The first entry of each chunk.
  std::vector<std::size_t> begins((touched_.size() + grain - 1) / grain + 1, 0);
  context.for_chunks(touched_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    begins[begin / grain + 1] = std::accumulate(&touched_[begin], touched_.data() + end, std::size_t{0});
  });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  // 2. Copy the entries and reset them to zero.
  Sums sums;
  sums.place.resize(begins.back());
  sums.sum.resize(begins.back() * bands_);
  context.for_chunks(touched_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    auto entry = begins[begin / grain];
    if (entry == begins[begin / grain + 1]) return;
    for (auto place = begin; place < end; ++place) {
      if (!touched_[place]) continue;
      touched_[place] = 0;
      auto* sum = &sums.sum[entry * bands_];
      for (auto from = place * bands_; from < counters_.size(); from += stride_)
        for (std::size_t b = 0; b < bands_; ++b) sum[b] += std::exchange(counters_[from + b], 0);
      sums.place[entry++] = static_cast<std::uint32_t>(place);
    }
  });
  return sums;
}

}  // namespace luxel
