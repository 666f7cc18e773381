// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/deposits.h"

#include <utility>

namespace luxel {
namespace {

constexpr std::size_t cache_lines = 16;       // counters in two lines, which processors fetch as a pair
constexpr std::size_t always_private = 1024;  // counters: a hot spot if shared, nothing to clear if not
constexpr std::size_t grain = 1 << 15;        // counters a chunk

bool pays(std::size_t counters, std::uint64_t expected_adds, const Workers& workers) {
  if (counters <= always_private) return true;
  const auto copies = counters * static_cast<std::size_t>(workers.threads());
  return expected_adds > copies && copies <= Deposits::private_bytes / sizeof(std::int64_t);
}

}  // namespace

Deposits::Deposits(std::size_t counters, std::uint64_t expected_adds, const Workers& workers)
    : count_(counters),
      is_private_(pays(counters, expected_adds, workers)),
      stride_((counters + cache_lines - 1) / cache_lines * cache_lines),
      counters_(is_private_ ? stride_ * static_cast<std::size_t>(workers.threads()) : counters, 0) {}

std::vector<std::int64_t> Deposits::take_total(const Workers& workers) {
  if (is_private_) {
    workers.for_chunks(count_, grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto copy = stride_; copy < counters_.size(); copy += stride_)
        for (auto i = begin; i < end; ++i) counters_[i] += counters_[copy + i];
    });
    counters_.resize(count_);
  }
  return std::move(counters_);
}

}  // namespace luxel
