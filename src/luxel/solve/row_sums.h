// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "luxel/core/work_partition.h"
#include "luxel/solve/hit_store.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// Which rays of one replicate arrive at each receiver: the receivers that sent them, in the order of the
// senders' blocks, so that sums over them have the same bits however the rays were traced. 4 bytes per ray
// and per receiver.
class Arrivals {
 public:
  Arrivals() = default;

  // for_each_pair(body) calls body(sender, receiver) for every ray that arrives at a receiver, in the order
  // of the senders' blocks, the same at each call; it is called twice.
  template <typename ForEachPair>
  static Arrivals sorted(std::size_t receivers, ForEachPair for_each_pair) {
    Arrivals a;
    a.begins_.assign(receivers + 1, 0);
    for_each_pair([&](std::uint32_t, std::uint32_t receiver) { ++a.begins_[receiver + 1]; });
    for (std::size_t s = 0; s < receivers; ++s) a.begins_[s + 1] += a.begins_[s];
    a.senders_ = std::make_unique_for_overwrite<std::uint32_t[]>(a.begins_.back());
    // Each begin moves to its end, which is the next one's begin.
    for_each_pair(
        [&](std::uint32_t sender, std::uint32_t receiver) { a.senders_[a.begins_[receiver]++] = sender; });
    for (std::size_t s = receivers; s > 0; --s) a.begins_[s] = a.begins_[s - 1];
    a.begins_[0] = 0;
    return a;
  }

  std::span<const std::uint32_t> at(std::size_t receiver) const {
    return {senders_.get() + begins_[receiver], begins_[receiver + 1] - begins_[receiver]};
  }

 private:
  std::vector<std::uint32_t> begins_;  // [receiver + 1]
  std::unique_ptr<std::uint32_t[]> senders_;
};

// Sender and receiver of each ray, one after the other.
using RayPairs = std::vector<std::uint32_t>;

// Sends each pair to the process that owns the receiver's row. own: this process's, in the order of the
// senders' blocks. Returns those whose rows this process owns, in the order of the blocks of all.
RayPairs exchanged_pairs(const RayPairs& own, const RowPartition& partition, const GatherSides& sides);

// A kernel adds the numbers of one ray: kernel(receiver, element, sum) to sum[0, width).
// kernel.fetch(element) prefetches the data that it will read. known_width: width where it is known to the
// compiler, else 0.

// The rays of one round: per_receiver hits of each receiver, one after the other.
struct OwnRays {
  std::span<const std::uint32_t> receivers;
  const std::uint32_t* hit;
  std::uint32_t per_receiver;
};

// Adds the receivers' own rays of one round. sums: [receiver - receiver0][width].
template <std::size_t known_width, typename Kernel>
void add_own_rays(const Kernel& kernel, std::size_t width, const OwnRays& rays, std::uint32_t receiver0,
                  double* sums) {
  const auto receivers = rays.receivers;
  const auto per_receiver = rays.per_receiver;
  const auto* hit = rays.hit;
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
