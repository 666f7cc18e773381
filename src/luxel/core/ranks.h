// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

namespace luxel {

// What a rank has got from the others so far, and how long it has waited for them and for it.
struct RankTraffic {
  std::uint64_t bytes = 0;
  double seconds = 0.0;
};

// Processes that solve one scene together. Each holds the scene and takes the same decisions; rows are shared
// out, and what one of them finds becomes known to all. Every call is made by all ranks, in the same order,
// from one thread of each. Throws DeviceError where another rank is gone, if that does not end this one.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual std::size_t rank() const = 0;
  virtual std::size_t size() const = 0;
  virtual RankTraffic traffic() const { return {}; }  // where it is measured
  // Ranks that share this one's memory, itself among them.
  virtual std::size_t on_this_machine() const { return 1; }

  // What each rank gives, one after the other: sizes[r] bytes from rank r. The same in all ranks. `own` may
  // lie in `all`, at its place there.
  virtual void all_gather(std::span<const std::byte> own, std::span<std::byte> all,
                          std::span<const std::size_t> sizes) const = 0;
  // Likewise, of a few bytes each: as many from every rank. They have come when wait() has returned, which is
  // soon once all ranks have called. Until then both stay where they are, and there is no other call.
  class Pending {
   public:
    virtual ~Pending() = default;
    virtual void wait() = 0;
  };
  virtual std::unique_ptr<Pending> start_all_gather(std::span<const std::byte> own,
                                                    std::span<std::byte> all) const = 0;
  // Like all_gather, but in the first rank alone; `all` of the others is not looked at.
  virtual void gather_to_first(std::span<const std::byte> own, std::span<std::byte> all,
                               std::span<const std::size_t> sizes) const = 0;
  // What the first rank has, in all.
  virtual void broadcast(std::span<std::byte> bytes) const = 0;
  // own[r]: what this rank has for rank r, read only; come[r]: room for what that one has for this.
  virtual void exchange(std::span<const std::span<const std::byte>> own,
                        std::span<const std::span<std::byte>> come) const = 0;
};

// One number, or other plain bytes, of each rank, in their order.
template <typename T>
std::vector<T> all_gather_value(const Ranks& ranks, const T& own) {
  std::vector<T> all(ranks.size());
  ranks.all_gather(std::as_bytes(std::span<const T>(&own, 1)), std::as_writable_bytes(std::span<T>(all)),
                   std::vector(all.size(), sizeof(T)));
  return all;
}

// What the first rank has, in all; without ranks, one's own.
template <typename T>
T agreed(const Ranks* ranks, T own) {
  if (ranks) ranks->broadcast(std::as_writable_bytes(std::span<T>(&own, 1)));
  return own;
}

// The lists of all ranks, one after the other.
template <typename T>
std::vector<T> all_gather_lists(const Ranks& ranks, const std::vector<T>& own) {
  auto sizes = all_gather_value(ranks, own.size() * sizeof(T));
  std::vector<T> all(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}) / sizeof(T));
  ranks.all_gather(std::as_bytes(std::span(own)), std::as_writable_bytes(std::span(all)), sizes);
  return all;
}

// own[r]: a list for rank r. Returns what each rank has for this one.
template <typename T>
std::vector<std::vector<T>> exchanged(const Ranks& ranks, const std::vector<std::vector<T>>& own) {
  std::vector<std::size_t> counts;
  for (const auto& list : own) counts.push_back(list.size());
  const auto counts_of_all = all_gather_lists(ranks, counts);
  std::vector<std::vector<T>> come;
  for (std::size_t r = 0; r < own.size(); ++r)
    come.emplace_back(counts_of_all[r * own.size() + ranks.rank()]);
  std::vector<std::span<const std::byte>> from;
  std::vector<std::span<std::byte>> to;
  for (std::size_t r = 0; r < own.size(); ++r) {
    from.push_back(std::as_bytes(std::span(own[r])));
    to.push_back(std::as_writable_bytes(std::span(come[r])));
  }
  ranks.exchange(from, to);
  return come;
}

// A loop over [0, count) in chunks of `grain` that ranks share: each does a range of whole chunks, one after
// the other. Without ranks, all of it is mine.
class LoopPartition {
 public:
  LoopPartition(const Ranks* ranks, std::size_t count, std::size_t grain)
      : ranks_(ranks), count_(count), grain_(grain) {}

  const Ranks* ranks() const { return ranks_; }
  std::size_t grain() const { return grain_; }
  std::size_t begin() const { return ranks_ ? begin_of(ranks_->rank()) : 0; }
  std::size_t end() const { return ranks_ ? begin_of(ranks_->rank() + 1) : count_; }
  bool contains(std::size_t i) const { return begin() <= i && i < end(); }
  // What each rank has put in its range becomes known to all. width: numbers for each of [0, count).
  template <typename T>
  void all_gather(std::span<T> values, std::size_t width) const {
    gather(values, [&](std::size_t i) { return i * width; });
  }
  // Likewise, of one number for each chunk.
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

  const Ranks* ranks_;
  std::size_t count_, grain_;
};

}  // namespace luxel
