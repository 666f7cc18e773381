// SPDX-License-Identifier: Apache-2.0
// The loops over rays of SampledOperator: what is added is the caller's.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/workers.h"
#include "luxel/solve/arrivals.h"
#include "luxel/solve/hit_store.h"

namespace luxel {

// A kernel adds the numbers of one ray: kernel(receiver, element, sum) to sum[0, width).
// kernel.fetch(element) asks for what it will read. known_width: width where it is known to the compiler,
// else 0.

// Adds the receivers' own rays of one round. sums: [receiver - receiver0][width].
template <std::size_t known_width, typename Kernel>
void add_own_rays(const Kernel& kernel, std::size_t width, std::span<const std::uint32_t> receivers,
                  const std::uint32_t* hit, std::uint32_t per_receiver, std::uint32_t receiver0,
                  double* sums) {
  constexpr std::size_t fetch_ahead = 16;  // hits
  const auto* const last = hit + receivers.size() * per_receiver - 1;
  for (const auto receiver : receivers) {
    if constexpr (known_width > 0) {
      std::array<double, known_width> sum{};  // in registers
      for (std::uint32_t i = 0; i < per_receiver; ++i, ++hit) {
        kernel.fetch(*std::min(hit + fetch_ahead, last));
        kernel(receiver, *hit, sum.data());
      }
      for (std::size_t k = 0; k < known_width; ++k) sums[known_width * (receiver - receiver0) + k] += sum[k];
    } else {
      for (std::uint32_t i = 0; i < per_receiver; ++i, ++hit) {
        kernel.fetch(*std::min(hit + fetch_ahead, last));
        kernel(receiver, *hit, sums + width * (receiver - receiver0));
      }
    }
  }
}

// Adds the rays that arrive at receivers [receiver0, end). sums: [receiver - receiver0][width].
template <std::size_t known_width, typename Kernel>
void add_arrivals(const Kernel& kernel, std::size_t width, const Arrivals& arrivals, std::uint32_t receiver0,
                  std::uint32_t end, double* sums) {
  constexpr std::ptrdiff_t fetch_ahead = 16;
  for (auto receiver = receiver0; receiver < end; ++receiver) {
    const auto senders = arrivals.at(receiver);
    const auto* const last = senders.data() + senders.size() - 1;
    if constexpr (known_width > 0) {
      auto* const to = sums + known_width * (receiver - receiver0);
      std::array<double, known_width> sum;
      std::copy_n(to, known_width, sum.data());
      for (const auto& sender : senders) {
        kernel.fetch(*std::min(&sender + fetch_ahead, last));
        kernel(receiver, sender, sum.data());
      }
      std::copy_n(sum.data(), known_width, to);
    } else {
      for (const auto& sender : senders) kernel(receiver, sender, sums + width * (receiver - receiver0));
    }
  }
}

// The rays of one replicate that a block's receivers send, held for a while.
class BlockRays {
 public:
  void trace(const HitStore& hits, std::uint32_t replicate, std::size_t block) {
    hits.for_each_round(
        replicate, block,
        [&](std::span<const std::uint32_t> receivers, const std::uint32_t* hit, std::uint32_t per_receiver) {
          rounds_.push_back({receivers, hits_.size(), per_receiver});
          hits_.insert(hits_.end(), hit, hit + receivers.size() * per_receiver);
        });
  }
  // Calls body(receivers, hits, hits per receiver).
  template <typename Body>
  void for_each_round(Body body) const {
    for (const auto& r : rounds_) body(r.receivers, hits_.data() + r.first, r.per_receiver);
  }

 private:
  struct Round {
    std::span<const std::uint32_t> receivers;
    std::size_t first = 0;
    std::uint32_t per_receiver = 0;
  };
  std::vector<Round> rounds_;
  std::vector<std::uint32_t> hits_;
};

}  // namespace luxel
