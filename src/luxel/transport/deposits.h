// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace luxel {

// Counters that many threads add to. Few counters: each worker has its own copy, so that a bright patch is no
// hot spot; many: one shared copy with atomic adds, where two threads seldom meet. The sums are the same
// either way.
class Deposits {
 public:
  Deposits(std::size_t counters, int workers);

  bool is_private() const { return is_private_; }

  // Adds `quantum` (one number a band) to the counters that begin at `first`. worker: who
  // adds.
  void add(int worker, std::size_t first, std::span<const std::int64_t> quantum) {
    auto* to = counters_.data() + first;
    if (is_private_) {
      to += static_cast<std::size_t>(worker) * stride_;
      for (std::size_t b = 0; b < quantum.size(); ++b) to[b] += quantum[b];
    } else {
      for (std::size_t b = 0; b < quantum.size(); ++b)
        if (quantum[b] != 0) __atomic_fetch_add(&to[b], quantum[b], __ATOMIC_RELAXED);
    }
  }

  // Says that counters that begin at `first` will be added to soon.
  void prefetch(int worker, std::size_t first) const {
    const auto copy = is_private_ ? static_cast<std::size_t>(worker) * stride_ : 0;
    __builtin_prefetch(counters_.data() + copy + first, 1);
  }

  // The sums over workers. Call once, when no thread adds.
  std::vector<std::int64_t> take_total();

 private:
  std::size_t count_;
  bool is_private_;
  std::size_t stride_;  // from one worker's copy to the next: whole cache lines, so that none is shared
  std::vector<std::int64_t> counters_;
};

}  // namespace luxel
