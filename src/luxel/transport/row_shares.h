// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/parallel/ranks.h"

namespace luxel {

// Which rank does which rows: blocks of neighbouring positions go round, so that each rank has some of
// every part of the scene and of every part of a sweep. Without ranks, all rows are mine and nothing is
// exchanged.
class RowShares {
 public:
  explicit RowShares(const Ranks* ranks, std::uint32_t positions_a_block)
      : ranks_(ranks && ranks->size() > 1 ? ranks : nullptr), positions_a_block_(positions_a_block) {}

  const Ranks* ranks() const { return ranks_; }
  std::size_t owner(std::uint32_t position) const {
    return ranks_ ? position / positions_a_block_ % ranks_->size() : 0;
  }
  bool is_mine(std::uint32_t position) const { return !ranks_ || owner(position) == ranks_->rank(); }

  // Each row's numbers become known to all ranks. Row i of `rows` is values[row_at(i) * width, ...) and
  // belongs to the owner of position_at(i).
  template <typename T, typename RowAt, typename PositionAt>
  void share(std::span<T> values, std::size_t width, std::size_t rows, RowAt row_at,
             PositionAt position_at) const {
    if (!ranks_) return;
    std::vector<std::size_t> count(ranks_->size(), 0);
    std::vector<T> own;
    for (std::size_t i = 0; i < rows; ++i) {
      const auto rank = owner(position_at(i));
      count[rank] += width;
      if (rank != ranks_->rank()) continue;
      const auto* row = &values[row_at(i) * width];
      own.insert(own.end(), row, row + width);
    }
    std::vector<std::size_t> next(ranks_->size(), 0), sizes(ranks_->size());
    std::size_t total = 0;
    for (std::size_t r = 0; r < sizes.size(); ++r) {
      next[r] = total;
      total += count[r];
      sizes[r] = count[r] * sizeof(T);
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

  // The numbers of all ranks, in their order.
  template <typename T>
  std::vector<T> of_all(const T& own) const {
    std::vector<T> all(ranks_ ? ranks_->size() : 1, own);
    if (ranks_)
      ranks_->all_gather(std::as_bytes(std::span<const T>(&own, 1)),
                         std::as_writable_bytes(std::span<T>(all)), std::vector(all.size(), sizeof(T)));
    return all;
  }

 private:
  const Ranks* ranks_;
  std::uint32_t positions_a_block_;
};

}  // namespace luxel
