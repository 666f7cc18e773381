// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/deposits.h"

#include <numeric>
#include <utility>

namespace luxel {
namespace {

constexpr std::size_t cache_lines = 16;       // counters in two lines, which processors fetch as a pair
constexpr std::size_t always_private = 1024;  // counters: a hot spot if shared, nothing to clear if not
constexpr std::size_t grain = 1 << 14;        // places a chunk

}  // namespace

Deposits::Deposits(std::size_t places, std::size_t bands, const Workers& workers)
    : bands_(bands),
      threads_(static_cast<std::size_t>(workers.threads())),
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

Deposits::Sums Deposits::take(const Workers& workers) {
  // 1. Where each chunk's entries begin.
  std::vector<std::size_t> begins((touched_.size() + grain - 1) / grain + 1, 0);
  workers.for_chunks(touched_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    begins[begin / grain + 1] = std::accumulate(&touched_[begin], touched_.data() + end, std::size_t{0});
  });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  // 2. The entries, and zero in their place.
  Sums sums;
  sums.place.resize(begins.back());
  sums.sum.resize(begins.back() * bands_);
  workers.for_chunks(touched_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
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
