// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "luxel/parallel/ranks.h"

namespace luxel {

// Which rank does which rows: blocks of neighbouring positions. At first they go round, so that each rank has
// some of every part of the scene and of every part of a sweep; later the slow ones give some away. Without
// ranks, all rows are mine and nothing is exchanged.
class RowShares {
 public:
  // positions: of all rows there will ever be.
  RowShares(const Ranks* ranks, std::uint32_t positions_a_block, std::span<const std::uint32_t> positions);

  const Ranks* ranks() const { return ranks_; }
  std::size_t block_of(std::uint32_t position) const { return position / positions_a_block_; }
  std::size_t owner(std::uint32_t position) const { return ranks_ ? owners_[block_of(position)] : 0; }
  bool is_mine(std::uint32_t position) const { return !ranks_ || owner(position) == ranks_->rank(); }
  // Who does a piece of work that any rank can do, number i of many: ranks get as many as they have blocks.
  std::size_t dealt(std::size_t i) const { return ranks_ ? owners_[i % owners_.size()] : 0; }
  bool is_dealt_to_me(std::size_t i) const { return !ranks_ || dealt(i) == ranks_->rank(); }

  // [block]; the same in all ranks.
  const std::vector<std::uint32_t>& owners() const { return owners_; }
  void set_owners(std::vector<std::uint32_t> owners) { owners_ = std::move(owners); }

  // Each row's numbers become known to all ranks. Row i of `rows` is values[row_at(i) * width, ...) and
  // belongs to the owner of position_at(i).
  template <typename T, typename RowAt, typename PositionAt>
  void share(std::span<T> values, std::size_t width, std::size_t rows, RowAt row_at,
             PositionAt position_at) const {
    share_of(values, width, rows, row_at, [&](std::size_t i) { return owner(position_at(i)); });
  }
  // Likewise, but it was rank_at(i) that did it.
  template <typename T, typename RowAt, typename RankAt>
  void share_of(std::span<T> values, std::size_t width, std::size_t rows, RowAt row_at,
                RankAt rank_at) const {
    if (!ranks_) return;
    // Runs of rows that lie side by side and have one owner.
    struct Run {
      std::size_t rank, begin, count;
    };
    std::vector<Run> runs;
    for (std::size_t i = 0; i < rows; ++i) {
      const auto rank = rank_at(i);
      const auto row = row_at(i);
      if (!runs.empty() && runs.back().rank == rank && runs.back().begin + runs.back().count == row)
        ++runs.back().count;
      else
        runs.push_back({rank, row, 1});
    }
    gather(values, width, runs);
  }
  // Likewise, of one number for each block.
  template <typename T>
  void share_blocks(std::span<T> values) const {
    share(
        values, 1, owners_.size(), [](std::size_t b) { return b; },
        [this](std::size_t b) { return static_cast<std::uint32_t>(b) * positions_a_block_; });
  }

 private:
  template <typename T, typename Runs>
  void gather(std::span<T> values, std::size_t width, const Runs& runs) const {
    const auto place = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    std::vector<std::size_t> sizes(ranks_->size(), 0);
    for (const auto& run : runs) sizes[run.rank] += run.count * width * sizeof(T);
    std::vector<T> own;
    own.reserve(sizes[ranks_->rank()] / sizeof(T));
    for (const auto& run : runs)
      if (run.rank == ranks_->rank())
        own.insert(own.end(), values.begin() + place(run.begin * width),
                   values.begin() + place((run.begin + run.count) * width));
    std::vector<std::size_t> next;
    std::size_t total = 0;
    for (const auto size : sizes) {
      next.push_back(total);
      total += size / sizeof(T);
    }
    const auto all = std::make_unique_for_overwrite<T[]>(total);
    ranks_->all_gather(std::as_bytes(std::span<const T>(own)),
                       std::as_writable_bytes(std::span<T>(all.get(), total)), sizes);
    for (const auto& run : runs) {
      const auto* from = all.get() + next[run.rank];
      std::copy_n(from, run.count * width, values.begin() + place(run.begin * width));
      next[run.rank] += run.count * width;
    }
  }

  const Ranks* ranks_;
  std::uint32_t positions_a_block_;
  std::vector<std::uint32_t> owners_;
};

// Who shall own each block, so that all ranks are done at about the same time: blocks move from the rank that
// would be last to the one that would be first, as few as it takes; none do where that would save less than a
// twentieth. owners, load: [block]; speed: [rank], load a second, above 0. The same in all ranks, whatever
// their order.
std::vector<std::uint32_t> balanced_owners(std::vector<std::uint32_t> owners, std::span<const double> load,
                                           std::span<const double> speed);

}  // namespace luxel
