// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/row_shares.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// Which rank takes the samples of which slots, where any rank can: pieces of neighbouring slots, dealt so
// that all ranks are done at once, by how long samples took before. Half of each rank's work is its first
// part, a quarter the second; the rest is dealt anew once it is known when each was done with the first, so
// what was foreseen wrongly is made good. Without ranks, all pieces are mine.
class PieceShares {
 public:
  static constexpr int parts = 3;

  // Keeps references to both, whatever becomes of the sides. Pieces go round until they are dealt.
  PieceShares(const RowShares& shares, const GatherSides& sides);

  bool is_mine(std::size_t slot) const {
    return !shares_.ranks() || owners_[piece_of(slot)] == shares_.ranks()->rank();
  }
  int part_of(std::size_t slot) const { return shares_.ranks() ? parts_[piece_of(slot)] : 0; }

  // What this rank measured: [i], of slots[i]; s of a thread for one sample, 0 where it took none.
  void learn(std::span<const std::uint32_t> slots, std::span<const double> seconds);
  // s of a thread that more samples, [slot], will take.
  double expected_seconds(std::span<const double> more) const;

  // Who takes so many more samples of each slot. times: when each rank is free.
  void deal(std::span<const double> more, const RankTimes& times);
  // Who takes those of the last part; times: when each rank was done with the first.
  void deal_rest(RankTimes times);

  // What ranks have done with these slots becomes known to all: `width` numbers a slot, of each list.
  void share(std::span<std::vector<float>> lists, std::size_t width, std::span<const std::uint32_t> slots);

 private:
  std::size_t piece_of(std::size_t slot) const;
  std::vector<double> expected(std::span<const double> more) const;  // [piece], s

  const RowShares& shares_;
  const GatherSides& sides_;
  // [piece]:
  std::vector<std::uint32_t> owners_;
  std::vector<std::uint8_t> parts_;
  std::vector<double> load_;              // s, as dealt
  std::vector<double> seconds_a_sample_;  // of a slot, as who took them measured; 0: not known
};

}  // namespace luxel
