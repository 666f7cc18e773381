// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/row_partition.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// Which rank takes the samples of which receivers, where any rank can: units of neighbouring receivers, dealt
// so that all ranks are done at once, by how long samples took before. Half of each rank's work is its first
// part, a quarter the second; the rest is dealt anew once it is known when each was done with the first, so
// what was foreseen wrongly is made good. Without ranks, all units are mine.
class WorkUnits {
 public:
  static constexpr int parts = 3;

  // Keeps references to both, whatever becomes of the sides. Pieces go round until they are dealt.
  WorkUnits(const RowPartition& partition, const GatherSides& sides);

  bool is_mine(std::size_t receiver) const {
    return !partition_.ranks() || owners_[unit_of(receiver)] == partition_.ranks()->rank();
  }
  int part_of(std::size_t receiver) const { return partition_.ranks() ? parts_[unit_of(receiver)] : 0; }

  // What this rank measured: [i], of receivers[i]; s of a thread for one sample, 0 where it took none.
  void learn(std::span<const std::uint32_t> receivers, std::span<const double> seconds);
  // s of a thread that more samples, [receiver], will take.
  double expected_seconds(std::span<const double> more) const;

  // Who takes so many more samples of each receiver. times: when each rank is free.
  void deal(std::span<const double> more, const RankTimes& times);
  // Who takes those of the last part; times: when each rank was done with the first.
  void deal_rest(RankTimes times);

  // What ranks have done with these receivers becomes known to all: `width` numbers per receiver, of each
  // list.
  void all_gather(std::span<std::vector<float>> lists, std::size_t width,
                  std::span<const std::uint32_t> receivers);

 private:
  std::size_t unit_of(std::size_t receiver) const;
  std::vector<double> expected(std::span<const double> more) const;  // [unit], s

  const RowPartition& partition_;
  const GatherSides& sides_;
  // [unit]:
  std::vector<std::uint32_t> owners_;
  std::vector<std::uint8_t> parts_;
  std::vector<double> load_;                // s, as dealt
  std::vector<double> seconds_per_sample_;  // of a receiver, as who took them measured; 0: not known
};

}  // namespace luxel
