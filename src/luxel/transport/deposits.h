// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/parallel/workers.h"

namespace luxel {

// Counters that many threads add to. As a rule each worker has its own copy: adds need no lock, and no line
// of memory wanders between processors. Where the copies would cost more than they save (few adds, or more
// memory than private_bytes) there is one shared copy with atomic adds. The sums are the same either way.
class Deposits {
 public:
  static constexpr std::size_t private_bytes = std::size_t{1} << 29;  // of all copies together

  // expected_adds: about how often add() will be called.
  Deposits(std::size_t counters, std::uint64_t expected_adds, const Workers& workers);

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
  std::vector<std::int64_t> take_total(const Workers& workers);

 private:
  std::size_t count_;
  bool is_private_;
  std::size_t stride_;  // from one worker's copy to the next: whole cache lines, so that none is shared
  std::vector<std::int64_t> counters_;
};

}  // namespace luxel
