// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"

namespace luxel {

// Counters that many threads add to: one per band at each place. Usually each thread has its own copy: adds
// need no lock, and no cache line moves between processors. Where the copies would cost more than they save
// (few adds, or more memory than private_bytes) there is one shared copy with atomic adds. The sums are the
// same either way.
//
// Places that were added to are marked, so that the cost of take() is proportional to their number; it reads
// one byte of each other place. Reuse a Deposits from batch to batch.
class Deposits {
 public:
  static constexpr std::size_t private_bytes = std::size_t{1} << 29;  // of all copies together

  // All zero. For adds by the threads of this context.
  Deposits(std::size_t places, std::size_t bands, const Context& context);

  // Prepares for about this many calls of add().
  void expect(std::uint64_t adds);
  bool is_private() const { return is_private_; }

  // Adds `quantum` (one number per band) at a place. thread: the index of the calling thread.
  void add(int thread, std::size_t place, std::span<const std::int64_t> quantum) {
    auto* to = counters_.data() + place * bands_;
    if (is_private_) {
      to += static_cast<std::size_t>(thread) * stride_;
      for (std::size_t b = 0; b < quantum.size(); ++b) to[b] += quantum[b];
    } else {
      for (std::size_t b = 0; b < quantum.size(); ++b)
        if (quantum[b] != 0) __atomic_fetch_add(&to[b], quantum[b], __ATOMIC_RELAXED);
    }
    auto* mark = &touched_[place];
    if (__atomic_load_n(mark, __ATOMIC_RELAXED) == 0)
      __atomic_store_n(mark, std::uint8_t{1}, __ATOMIC_RELAXED);
  }

  // Says that a place will be added to soon.
  void prefetch(int thread, std::size_t place) const {
    const auto copy = is_private_ ? static_cast<std::size_t>(thread) * stride_ : 0;
    __builtin_prefetch(counters_.data() + copy + place * bands_, 1);
    __builtin_prefetch(touched_.data() + place, 1);
  }

  // Returns the sums since the beginning or the last take, over all threads, and resets them. Call when no
  // thread adds.
  struct Sums {
    std::vector<std::uint32_t> place;  // that were added to, rising
    std::vector<std::int64_t> sum;     // [entry of place][band]
  };
  Sums take(const Context& context);

 private:
  std::size_t bands_;
  std::size_t threads_;
  std::size_t stride_;  // from one thread's copy to the next: whole cache lines, so that none is shared
  bool is_private_ = false;
  std::vector<std::int64_t> counters_;
  std::vector<std::uint8_t> touched_;  // [place], of all copies
};

}  // namespace luxel
