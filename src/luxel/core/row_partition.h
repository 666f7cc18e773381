// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "luxel/core/ranks.h"

namespace luxel {

// Which rank does which rows, for one thread of each rank: blocks of neighbouring positions. At first they go
// round, up to four together, so that each rank has some of every part of the scene and of every part of a
// sweep; later the slow ones give some away. Without ranks, all rows are mine and nothing is exchanged.
class RowPartition {
 public:
  // positions: of all rows there will ever be.
  RowPartition(const Ranks* ranks, std::uint32_t positions_per_block,
               std::span<const std::uint32_t> positions);

  const Ranks* ranks() const { return ranks_; }
  std::size_t block_of(std::uint32_t position) const { return position / positions_per_block_; }
  std::size_t owner(std::uint32_t position) const { return ranks_ ? owners_[block_of(position)] : 0; }
  bool is_mine(std::uint32_t position) const { return !ranks_ || owner(position) == ranks_->rank(); }

  // [block]; the same in all ranks.
  const std::vector<std::uint32_t>& owners() const { return owners_; }
  void set_owners(std::vector<std::uint32_t> owners) { owners_ = std::move(owners); }

  // Rows that lie side by side and were done by one rank.
  struct Run {
    std::size_t rank = 0, begin = 0, count = 0;
  };
  // Each row's numbers, `width` of them, become known to all ranks. No row is in two runs.
  template <typename T>
  void all_gather_runs(std::span<T> values, std::size_t width, std::span<const Run> runs) const {
    if (!ranks_) return;
    const auto rank = ranks_->rank();
    std::vector<std::size_t> sizes(ranks_->size(), 0);
    for (const auto& run : runs) sizes[run.rank] += run.count * width * sizeof(T);
    std::vector<std::size_t> next(1, 0);  // of each rank, what is not yet packed or unpacked
    for (const auto size : sizes) next.push_back(next.back() + size);
    if (room_.size() < next.back()) room_.resize(next.back());
    const auto all = std::span(room_).first(next.back());
    const auto own = all.subspan(next[rank], sizes[rank]);
    const auto bytes_of = [&](const Run& run) {
      return std::as_writable_bytes(values.subspan(run.begin * width, run.count * width));
    };
    for (auto to = own.begin(); const auto& run : runs)
      if (run.rank == rank) {
        const auto from = bytes_of(run);
        to = std::copy(from.begin(), from.end(), to);
      }
    ranks_->all_gather(own, all, sizes);
    for (const auto& run : runs) {
      if (run.rank == rank) continue;
      const auto to = bytes_of(run);
      std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(next[run.rank]), to.size(), to.begin());
      next[run.rank] += to.size();
    }
  }
  // Likewise: row i of `rows` is row row_at(i) of the values, and rank_at(i) did it.
  template <typename T, typename RowAt, typename RankAt>
  void all_gather_rows(std::span<T> values, std::size_t width, std::size_t rows, RowAt row_at,
                       RankAt rank_at) const {
    if (ranks_) all_gather_runs(values, width, runs_of(rows, row_at, rank_at));
  }
  template <typename RowAt, typename RankAt>
  static std::vector<Run> runs_of(std::size_t rows, RowAt row_at, RankAt rank_at) {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < rows; ++i) {
      const std::size_t rank = rank_at(i);
      const std::size_t row = row_at(i);
      if (!runs.empty() && runs.back().rank == rank && runs.back().begin + runs.back().count == row)
        ++runs.back().count;
      else
        runs.push_back({rank, row, 1});
    }
    return runs;
  }
  // Likewise, and the owner of position_at(i) did row i.
  template <typename T, typename RowAt, typename PositionAt>
  void all_gather(std::span<T> values, std::size_t width, std::size_t rows, RowAt row_at,
                  PositionAt position_at) const {
    all_gather_rows(values, width, rows, row_at, [&](std::size_t i) { return owner(position_at(i)); });
  }
  // Likewise, of one number for each block.
  template <typename T>
  void all_gather_blocks(std::span<T> values) const {
    all_gather(
        values, 1, owners_.size(), [](std::size_t b) { return b; },
        [this](std::size_t b) { return static_cast<std::uint32_t>(b) * positions_per_block_; });
  }

 private:
  const Ranks* ranks_;
  std::uint32_t positions_per_block_;
  std::vector<std::uint32_t> owners_;
  mutable std::vector<std::byte> room_;  // for what comes; kept, since to get pages anew takes longer
};

// How fast each rank works, and when it will be done with what it has.
struct RankTimes {
  std::vector<double> speed;  // [rank]: threads that are at work, above 0
  std::vector<double> ready;  // [rank], s
};

// Who shall own each block, so that all ranks are done at about the same time: blocks move from the rank that
// would be last to the one that would be first, as few as it takes; none do where that would save less than a
// twentieth. owners, load: [block]; speed: [rank], load a second, above 0; other: load that is not of blocks,
// and goes to who is free. The same in all ranks, whatever their order.
std::vector<std::uint32_t> balanced_owners(std::vector<std::uint32_t> owners, std::span<const double> load,
                                           std::span<const double> speed, double other = 0.0);

// Indices of loads, the heaviest first; those of one weight in their order.
std::vector<std::uint32_t> heaviest_first(std::span<const double> load);

// Who does each unit of work that any rank can do: the largest first, to who will be done with it first.
std::vector<std::uint32_t> dealt_units(std::span<const double> load, const RankTimes& times);

}  // namespace luxel
