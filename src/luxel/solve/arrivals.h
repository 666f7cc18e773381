// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "luxel/core/ranks.h"
#include "luxel/core/row_partition.h"
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

// Of several ranks: sends each pair to the rank that owns the receiver's row. own: this rank's, in the order
// of the senders' blocks. Returns those whose rows this rank owns, in the order of the blocks of all.
RayPairs exchanged_pairs(const RayPairs& own, const RowPartition& partition, const GatherSides& sides);

}  // namespace luxel
