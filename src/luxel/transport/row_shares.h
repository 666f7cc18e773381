// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

  // [block]; the same in all ranks.
  const std::vector<std::uint32_t>& owners() const { return owners_; }
  void set_owners(std::vector<std::uint32_t> owners) { owners_ = std::move(owners); }

  // Each row's numbers become known to all ranks. Row i of `rows` is values[row_at(i) * width, ...) and
  // belongs to the owner of position_at(i).
  template <typename T, typename RowAt, typename PositionAt>
  void share(std::span<T> values, std::size_t width, std::size_t rows, RowAt row_at,
             PositionAt position_at) const {
    if (!ranks_) return;
    std::vector<std::size_t> sizes(ranks_->size(), 0);
    std::vector<T> own;
    for (std::size_t i = 0; i < rows; ++i) {
      const auto rank = owner(position_at(i));
      sizes[rank] += width * sizeof(T);
      if (rank != ranks_->rank()) continue;
      const auto* row = &values[row_at(i) * width];
      own.insert(own.end(), row, row + width);
    }
    std::vector<std::size_t> next;
    std::size_t total = 0;
    for (const auto size : sizes) {
      next.push_back(total);
      total += size / sizeof(T);
    }
    std::vector<T> all(total);
    ranks_->all_gather(std::as_bytes(std::span<const T>(own)), std::as_writable_bytes(std::span<T>(all)),
                       sizes);
    for (std::size_t i = 0; i < rows; ++i) {
      auto& from = next[owner(position_at(i))];
      std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(from), width, &values[row_at(i) * width]);
      from += width;
    }
  }

 private:
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
