// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/arrivals.h"

namespace luxel {

RayPairs exchanged_pairs(const RayPairs& own, const RowPartition& partition, const GatherSides& sides) {
  const auto& ranks = *partition.ranks();
  const auto block_of = [&](std::uint32_t receiver) {
    return 2 * partition.block_of(sides.position[receiver]) + (receiver < sides.fronts ? 0 : 1);
  };
  std::vector<RayPairs> parcels(ranks.size());
  for (std::size_t i = 0; i < own.size(); i += 2) {
    auto& parcel = parcels[partition.owner(sides.position[own[i + 1]])];
    parcel.push_back(own[i]);
    parcel.push_back(own[i + 1]);
  }
  const auto received = exchanged(ranks, parcels);
  // Every parcel is in the order of the senders' blocks, each block has one owner, and its receivers lie side
  // by side.
  RayPairs merged;
  std::size_t size = 0;
  for (const auto& parcel : received) size += parcel.size();
  merged.reserve(size);
  std::vector<std::size_t> next(received.size(), 0);
  while (merged.size() < size) {
    std::size_t first = received.size();
    for (std::size_t r = 0; r < received.size(); ++r)
      if (next[r] < received[r].size() &&
          (first == received.size() || received[r][next[r]] < received[first][next[first]]))
        first = r;
    auto& at = next[first];
    const auto block = block_of(received[first][at]);
    while (at < received[first].size() && block_of(received[first][at]) == block) {
      merged.push_back(received[first][at]);
      merged.push_back(received[first][at + 1]);
      at += 2;
    }
  }
  return merged;
}

}  // namespace luxel
