// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/deposits.h"

#include <utility>

namespace luxel {
namespace {

constexpr std::size_t cache_lines = 16;         // counters in two lines, which processors fetch as a pair
constexpr std::size_t private_up_to = 1 << 15;  // counters: 256 KiB a worker stays in the second-level cache

}  // namespace

Deposits::Deposits(std::size_t counters, int workers)
    : count_(counters),
      is_private_(counters <= private_up_to),
      stride_((counters + cache_lines - 1) / cache_lines * cache_lines),
      counters_(is_private_ ? stride_ * static_cast<std::size_t>(workers) : counters, 0) {}

std::vector<std::int64_t> Deposits::take_total() {
  if (!is_private_) return std::move(counters_);
  std::vector<std::int64_t> sum(count_, 0);
  for (std::size_t copy = 0; copy < counters_.size(); copy += stride_)
    for (std::size_t i = 0; i < count_; ++i) sum[i] += counters_[copy + i];
  return sum;
}

}  // namespace luxel
