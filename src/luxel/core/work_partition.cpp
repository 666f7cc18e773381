// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/work_partition.h"

#include <functional>
#include <numeric>
#include <queue>
#include <tuple>

namespace luxel {
namespace {

constexpr double worth_moving = 1.05;  // time of the slowest rank over the mean, above which blocks move
constexpr double good_enough = 1.01;   // and at which moving ends
// Adjacent blocks start with one owner: rays of similar directions from neighbouring blocks are traced
// together.
constexpr std::size_t max_together = 4;

}  // namespace

RowPartition::RowPartition(const SharedWork& work, std::uint32_t positions_per_block,
                           std::span<const std::uint32_t> positions)
    : SharedWork(work), positions_per_block_(positions_per_block) {
  if (!ranks_ || positions.empty()) return;
  owners_.resize(block_of(*std::max_element(positions.begin(), positions.end())) + 1);
  const auto together = std::clamp<std::size_t>(owners_.size() / (8 * ranks_->size()), 1, max_together);
  for (std::size_t b = 0; b < owners_.size(); ++b)
    owners_[b] = static_cast<std::uint32_t>(b / together % ranks_->size());
}

std::vector<std::uint32_t> balanced_owners(std::vector<std::uint32_t> owners, std::span<const double> load,
                                           std::span<const double> speed, double other) {
  std::vector<double> time(speed.size(), 0.0);
  std::vector<std::vector<std::uint32_t>> blocks(speed.size());  // of each rank, the heaviest last
  for (std::uint32_t b = 0; b < owners.size(); ++b) {
    time[owners[b]] += load[b] / speed[owners[b]];
    if (load[b] > 0.0) blocks[owners[b]].push_back(b);
  }
  for (auto& own : blocks)
    std::stable_sort(own.begin(), own.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return load[a] < load[b]; });
  const auto mean =
      std::accumulate(load.begin(), load.end(), other) / std::accumulate(speed.begin(), speed.end(), 0.0);
  auto last = std::max_element(time.begin(), time.end());
  if (*last <= worth_moving * mean) return owners;
  while (*last > good_enough * mean) {
    const auto from = static_cast<std::size_t>(last - time.begin());
    const auto to = static_cast<std::size_t>(std::min_element(time.begin(), time.end()) - time.begin());
    // The heaviest block after whose move the other rank still finishes earlier than this one does now.
    auto& own = blocks[from];
    const auto most = (time[from] - time[to]) * speed[to];
    const auto end =
        std::partition_point(own.begin(), own.end(), [&](std::uint32_t b) { return load[b] < most; });
    if (end == own.begin()) break;
    const auto block = *(end - 1);
    own.erase(end - 1);
    owners[block] = static_cast<std::uint32_t>(to);
    auto& others = blocks[to];
    others.insert(std::partition_point(others.begin(), others.end(),
                                       [&](std::uint32_t b) { return load[b] <= load[block]; }),
                  block);
    time[from] -= load[block] / speed[from];
    time[to] += load[block] / speed[to];
    last = std::max_element(time.begin(), time.end());
  }
  return owners;
}

std::vector<std::uint32_t> heaviest_first(std::span<const double> load) {
  std::vector<std::uint32_t> order(load.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return load[a] > load[b]; });
  return order;
}

std::vector<std::uint32_t> dealt_units(std::span<const double> load, const ProcessTimes& times) {
  using Rank = std::tuple<double, std::uint32_t>;  // time at which it is ready, and its number
  std::priority_queue<Rank, std::vector<Rank>, std::greater<>> ranks;
  for (std::uint32_t r = 0; r < times.ready.size(); ++r) ranks.emplace(times.ready[r], r);
  std::vector<std::uint32_t> owners(load.size());
  for (const auto unit : heaviest_first(load)) {
    const auto [ready, rank] = ranks.top();
    ranks.pop();
    owners[unit] = rank;
    ranks.emplace(ready + load[unit] / times.speed[rank], rank);
  }
  return owners;
}

}  // namespace luxel
