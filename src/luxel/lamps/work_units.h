// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/work_partition.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// Partition of samples among processes: units of neighbouring receivers, assigned so that all processes
// finish together, by the measured duration of earlier samples. Half of the work of each is its first part, a
// quarter the second; the rest is assigned again once it is known when each has finished the first, which
// corrects the estimate.
class WorkUnits {
 public:
  static constexpr int parts = 3;

  // Keeps references to both, whatever becomes of the sides. Units are dealt in turn at first.
  WorkUnits(const RowPartition& partition, const GatherSides& sides);

  bool is_mine(std::size_t receiver) const {
    return !partition_.is_shared() || owners_[unit_of(receiver)] == partition_.process();
  }
  int part_of(std::size_t receiver) const { return partition_.is_shared() ? parts_[unit_of(receiver)] : 0; }

  // Records measured times: seconds[i], of receivers[i]; s of a thread for one sample, 0 where it took none.
  void learn(std::span<const std::uint32_t> receivers, std::span<const double> seconds);
  // s of a thread that more samples, [receiver], will take.
  double expected_seconds(std::span<const double> more) const;

  // Assigns this many more samples of each receiver. times: when each process is free.
  void deal(std::span<const double> more, const ProcessTimes& times);
  // Assigns the samples of the last part; times: when each process was done with the first.
  void deal_rest(ProcessTimes times);

  // Gathers the results of processes for these receivers in all processes: `width` numbers per receiver, of
  // each list.
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
  std::vector<double> seconds_per_sample_;  // of a receiver, as measured by their process; 0: unknown
};

}  // namespace luxel
