// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/ranks.h"

namespace luxel {

// Work that the processes of a run divide: number of processes, index of this one, and exchange of results. A
// process that is alone owns everything and exchanges nothing.
class SharedWork {
 public:
  SharedWork() = default;  // of one process
  explicit SharedWork(const Context& context) : ranks_(context.ranks()) {}

  bool is_shared() const { return ranks_ != nullptr; }
  std::size_t processes() const { return ranks_ ? ranks_->size() : 1; }
  std::size_t process() const { return ranks_ ? ranks_->rank() : 0; }
  Traffic traffic() const { return ranks_ ? ranks_->traffic() : Traffic{}; }
  std::size_t processes_on_this_machine() const { return ranks_ ? ranks_->on_this_machine() : 1; }
  const Ranks* ranks() const { return ranks_; }  // null where this process is alone

  // The value of the first process, in all.
  template <typename T>
  T broadcast(T own) const {
    if (ranks_) ranks_->broadcast(std::as_writable_bytes(std::span<T>(&own, 1)));
    return own;
  }
  // The value of each process, in their order.
  template <typename T>
  std::vector<T> all_gather_value(const T& own) const {
    std::vector<T> all(processes(), own);
    if (ranks_)
      ranks_->all_gather(std::as_bytes(std::span<const T>(&own, 1)),
                         std::as_writable_bytes(std::span<T>(all)), std::vector(all.size(), sizeof(T)));
    return all;
  }
  // Starts all_gather_value() without blocking; wait() finishes it. Until then `own` and `all` must stay in
  // place. Null where this process is alone.
  template <typename T>
  std::unique_ptr<Ranks::Pending> start_all_gather_value(const T& own, std::span<T> all) const {
    if (!ranks_) return nullptr;
    return ranks_->start_all_gather(std::as_bytes(std::span<const T>(&own, 1)), std::as_writable_bytes(all));
  }
  // The lists of all processes, one after the other.
  template <typename T>
  std::vector<T> all_gather_lists(const std::vector<T>& own) const {
    if (!ranks_) return own;
    auto sizes = all_gather_value(own.size() * sizeof(T));
    std::vector<T> all(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}) / sizeof(T));
    ranks_->all_gather(std::as_bytes(std::span(own)), std::as_writable_bytes(std::span(all)), sizes);
    return all;
  }
  // own[r]: a list for process r. Returns the list of each process for this one.
  template <typename T>
  std::vector<std::vector<T>> all_to_all(const std::vector<std::vector<T>>& own) const {
    if (!ranks_) return own;
    std::vector<std::size_t> counts;
    for (const auto& list : own) counts.push_back(list.size());
    const auto counts_of_all = all_gather_lists(counts);
    std::vector<std::vector<T>> come;
    for (std::size_t r = 0; r < own.size(); ++r) come.emplace_back(counts_of_all[r * own.size() + process()]);
    std::vector<std::span<const std::byte>> from;
    std::vector<std::span<std::byte>> to;
    for (std::size_t r = 0; r < own.size(); ++r) {
      from.push_back(std::as_bytes(std::span(own[r])));
      to.push_back(std::as_writable_bytes(std::span(come[r])));
    }
    ranks_->exchange(from, to);
    return come;
  }

 protected:
  const Ranks* ranks_ = nullptr;
};

// A loop over [0, count) in chunks of `grain` that processes share: each does a range of whole chunks, one
// after the other.
class LoopPartition : public SharedWork {
 public:
  LoopPartition(const SharedWork& work, std::size_t count, std::size_t grain)
      : SharedWork(work), count_(count), grain_(grain) {}

  std::size_t grain() const { return grain_; }
  std::size_t begin() const { return ranks_ ? begin_of(ranks_->rank()) : 0; }
  std::size_t end() const { return ranks_ ? begin_of(ranks_->rank() + 1) : count_; }
  bool contains(std::size_t i) const { return begin() <= i && i < end(); }
  // Gathers the range of each rank in all ranks. width: numbers for each of [0, count).
  template <typename T>
  void all_gather(std::span<T> values, std::size_t width) const {
    gather(values, [&](std::size_t i) { return i * width; });
  }
  // Gathers one number for each chunk in all ranks.
  template <typename T>
  void all_gather_chunks(std::span<T> values) const {
    gather(values, [&](std::size_t i) { return (i + grain_ - 1) / grain_; });
  }

 private:
  std::size_t begin_of(std::size_t rank) const {
    const auto chunks = (count_ + grain_ - 1) / grain_;
    return std::min(count_, chunks * rank / ranks_->size() * grain_);
  }
  template <typename T, typename PlaceOf>
  void gather(std::span<T> values, PlaceOf place_of) const {
    if (!ranks_) return;
    std::vector<std::size_t> sizes;
    for (std::size_t r = 0; r < ranks_->size(); ++r)
      sizes.push_back((place_of(begin_of(r + 1)) - place_of(begin_of(r))) * sizeof(T));
    const auto own = values.subspan(place_of(begin()), place_of(end()) - place_of(begin()));
    ranks_->all_gather(std::as_bytes(own), std::as_writable_bytes(values), sizes);
  }

  std::size_t count_, grain_;
};

// Assignment of rows to processes, in blocks of neighbouring positions. At first they are dealt in turn, up
// to four together, so that each process has some of every part of the scene and of every part of a sweep;
// later, slow processes lose some. To be called from one thread of each process.
class RowPartition : public SharedWork {
 public:
  // positions: of all rows there will ever be.
  RowPartition(const SharedWork& work, std::uint32_t positions_per_block,
               std::span<const std::uint32_t> positions);

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
  // Gathers the numbers of each row, `width` of them, in all ranks. No row is in two runs.
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
  // Gathers rows, where row i of `rows` is row row_at(i) of the values, computed by rank_at(i).
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
  // Gathers rows, where the owner of position_at(i) computed row i.
  template <typename T, typename RowAt, typename PositionAt>
  void all_gather(std::span<T> values, std::size_t width, std::size_t rows, RowAt row_at,
                  PositionAt position_at) const {
    all_gather_rows(values, width, rows, row_at, [&](std::size_t i) { return owner(position_at(i)); });
  }
  // Gathers one number for each block in all ranks.
  template <typename T>
  void all_gather_blocks(std::span<T> values) const {
    all_gather(
        values, 1, owners_.size(), [](std::size_t b) { return b; },
        [this](std::size_t b) { return static_cast<std::uint32_t>(b) * positions_per_block_; });
  }

 private:
  std::uint32_t positions_per_block_;
  std::vector<std::uint32_t> owners_;
  mutable std::vector<std::byte> room_;  // receive buffer; reused, since allocating pages again takes longer
};

// Speed of each process, and the time when it finishes its current work.
struct ProcessTimes {
  std::vector<double> speed;  // [rank]: threads that are at work, above 0
  std::vector<double> ready;  // [rank], s
};

// Assigns owners to blocks so that all ranks finish at about the same time. Blocks move from the rank that
// would finish last to the one that would finish first, as few as possible; none move where that would save
// less than a twentieth. owners, load: [block]; speed: [rank], load per second, above 0; other: load that
// belongs to no block and goes to ranks that are free. The result is the same in all ranks, whatever their
// order.
std::vector<std::uint32_t> balanced_owners(std::vector<std::uint32_t> owners, std::span<const double> load,
                                           std::span<const double> speed, double other = 0.0);

// Returns the indices of loads, the heaviest first; equal loads keep their order.
std::vector<std::uint32_t> heaviest_first(std::span<const double> load);

// Assigns units of work that any rank can do: the largest first, each to the rank that would finish it first.
std::vector<std::uint32_t> dealt_units(std::span<const double> load, const ProcessTimes& times);

}  // namespace luxel
