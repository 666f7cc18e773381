// SPDX-License-Identifier: Apache-2.0
// What a sampled operator does with other ranks: who has which rows, and their hits.
#include <algorithm>
#include <numeric>

#include "luxel/solve/hit_store.h"

namespace luxel {

std::vector<std::uint32_t> HitStore::mine(std::vector<std::uint32_t> slots) const {
  if (shares_.ranks()) std::erase_if(slots, [this](std::uint32_t s) { return !is_mine(s); });
  return slots;
}

// The round of all ranks, with its hits in the first one.
HitRound HitStore::gathered(const HitRound& own) const {
  const auto& ranks = *shares_.ranks();
  const auto slots = joined(ranks, own.slots);  // rank after rank
  std::vector<std::size_t> order(slots.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return slots[a] < slots[b]; });
  HitRound whole{own.level, own.per_replicate, {}, nullptr};
  for (const auto i : order) whole.slots.push_back(slots[i]);
  const auto streamed = of_all(ranks, is_streamed_ ? 1 : 0);
  if (std::count(streamed.begin(), streamed.end(), 0) < std::ssize(streamed)) return whole;
  const auto n = std::size_t{own.per_replicate};
  const bool is_first = ranks.rank() == 0;
  if (is_first)
    whole.hits =
        std::make_shared_for_overwrite<std::uint32_t[]>(options_.replicates * whole.hits_a_replicate());
  std::vector<std::size_t> sizes;
  for (const auto count : of_all(ranks, own.slots.size())) sizes.push_back(count * n * sizeof(std::uint32_t));
  std::vector<std::uint32_t> hits(is_first ? slots.size() * n : 0);
  for (std::uint32_t r = 0; r < options_.replicates; ++r) {
    const auto from = std::span(own.hits.get() + r * own.hits_a_replicate(), own.hits_a_replicate());
    ranks.gather_to_first(std::as_bytes(from), std::as_writable_bytes(std::span(hits)), sizes);
    if (!is_first) continue;
    auto* to = whole.hits.get() + r * whole.hits_a_replicate();
    for (const auto i : order) to = std::copy_n(&hits[i * n], n, to);
  }
  return whole;
}

void HitStore::share_slots(std::span<float> values, std::size_t width) const {
  if (!shares_.ranks()) return;
  std::vector<RowShares::Run> runs;
  for (std::size_t b = 0; b < blocks(); ++b) {
    const auto slot = block_begins_[b];
    runs.push_back({shares_.owner(sides_.position[slot]), slot, block_begins_[b + 1] - slot});
  }
  shares_.share_runs(values, width, runs);
}

std::vector<HitRound> HitStore::rounds() const {
  if (!shares_.ranks()) return {rounds_.begin(), rounds_.end()};
  std::vector<HitRound> all;
  for (const auto& round : rounds_) all.push_back(gathered(round));
  return all;
}

HitStore::Round HitStore::own_part(const Round& whole) const {
  auto own = make_round({whole.level, whole.per_replicate, mine(whole.slots), nullptr});
  if (!whole.hits) return own;
  make_room(own);
  for (std::uint32_t r = 0; r < options_.replicates; ++r) {
    auto* to = own.hits_of(r, 0);
    for (std::size_t i = 0; i < whole.slots.size(); ++i)
      if (is_mine(whole.slots[i])) to = std::copy_n(whole.hits_of(r, i), whole.per_replicate, to);
  }
  return own;
}

void HitStore::learn_pace(const Round& own, std::span<const std::uint32_t> groups,
                          std::span<const double> job_seconds, double seconds) {
  if (!shares_.ranks()) return;
  const auto jobs_a_group = groups.size() > 1 ? job_seconds.size() / (groups.size() - 1) : 0;
  double busy = 0.0;
  std::vector<double> cost(shares_.owners().size(), 0.0), slots(cost.size(), 0.0);
  for (std::size_t g = 0; g + 1 < groups.size(); ++g) {
    double whole = 0.0;
    for (std::size_t j = 0; j < jobs_a_group; ++j) whole += job_seconds[g * jobs_a_group + j];
    busy += whole;
    for (auto i = groups[g]; i < groups[g + 1]; ++i) {
      const auto block = shares_.block_of(sides_.position[own.slots[i]]);
      cost[block] += whole / (groups[g + 1] - groups[g]);
      slots[block] += 1.0;
    }
  }
  if (!(busy > 0.0 && seconds > 0.0)) return;
  busy_seconds_ += busy;
  traced_seconds_ += seconds;
  seconds_a_slot_.resize(cost.size(), 0.0);
  for (std::size_t b = 0; b < cost.size(); ++b)
    if (slots[b] > 0.0) seconds_a_slot_[b] = cost[b] / (slots[b] * own.per_replicate);
}

RankTimes HitStore::balance(std::span<const double> more_rays, double other_seconds) {
  if (!shares_.ranks()) return {{1.0}, {0.0}};
  const auto& ranks = *shares_.ranks();
  RankTimes times;
  times.ready.resize(ranks.size(), 0.0);
  const bool is_known = traced_seconds_ > 0.0 && !is_streamed_;
  times.speed = of_all(ranks, is_known ? busy_seconds_ / traced_seconds_ : 0.0);
  busy_seconds_ = traced_seconds_ = 0.0;
  if (*std::min_element(times.speed.begin(), times.speed.end()) <= 0.0) {
    times.speed.assign(ranks.size(), 1.0);
    return times;
  }
  std::vector<double> load(shares_.owners().size(), 0.0);
  for (std::size_t s = 0; s < more_rays.size(); ++s)
    load[shares_.block_of(sides_.position[s])] += more_rays[s];
  seconds_a_slot_.resize(load.size(), 0.0);
  shares_.share_blocks(std::span(seconds_a_slot_));
  for (std::size_t b = 0; b < load.size(); ++b) load[b] *= seconds_a_slot_[b];
  auto owners = balanced_owners(shares_.owners(), load, times.speed, other_seconds);
  if (owners != shares_.owners()) move_rows(std::move(owners));
  for (std::size_t b = 0; b < load.size(); ++b)
    times.ready[shares_.owners()[b]] += load[b] / times.speed[shares_.owners()[b]];
  return times;
}

// For each rank, of each round in turn: how many slots it gets, these, and their hits.
void HitStore::move_rows(std::vector<std::uint32_t> owners) {
  const auto& ranks = *shares_.ranks();
  const auto rank = ranks.rank();
  const auto owner_of = [&](std::uint32_t slot) { return owners[shares_.block_of(sides_.position[slot])]; };
  std::vector<std::vector<std::uint32_t>> parcels(ranks.size());
  for (const auto& round : rounds_) {
    std::vector<std::vector<std::uint32_t>> places(ranks.size());  // of the slots that go there
    for (std::uint32_t i = 0; i < round.slots.size(); ++i) places[owner_of(round.slots[i])].push_back(i);
    for (std::size_t r = 0; r < ranks.size(); ++r) {
      if (r == rank) continue;
      auto& parcel = parcels[r];
      parcel.push_back(static_cast<std::uint32_t>(places[r].size()));
      for (const auto i : places[r]) parcel.push_back(round.slots[i]);
      for (std::uint32_t k = 0; k < options_.replicates; ++k)
        for (const auto i : places[r])
          parcel.insert(parcel.end(), round.hits_of(k, i), round.hits_of(k, i) + round.per_replicate);
    }
  }
  const auto come = exchanged(ranks, parcels);
  parcels.clear();
  std::vector<const std::uint32_t*> next;  // of each parcel, what is not yet unpacked
  for (const auto& parcel : come) next.push_back(parcel.data());
  for (auto& round : rounds_) {
    // Lists of slots with where the hits of the first replicate are, and how far on those of the next.
    struct Row {
      std::uint32_t slot;
      const std::uint32_t* hits;
      std::size_t stride;
    };
    const std::size_t n = round.per_replicate;
    std::vector<Row> rows;
    for (std::size_t i = 0; i < round.slots.size(); ++i)
      if (owner_of(round.slots[i]) == rank)
        rows.push_back({round.slots[i], round.hits_of(0, i), round.hits_a_replicate()});
    const auto stayed = rows.size();
    for (auto& at : next) {
      if (&at == &next[rank]) continue;
      const std::size_t count = *at++;
      const auto* hits = at + count;
      const auto middle = std::ssize(rows);
      for (std::size_t i = 0; i < count; ++i) rows.push_back({at[i], hits + i * n, count * n});
      std::inplace_merge(rows.begin(), rows.begin() + middle, rows.end(),
                         [](const Row& a, const Row& b) { return a.slot < b.slot; });
      at = hits + options_.replicates * count * n;
    }
    if (stayed == round.slots.size() && stayed == rows.size()) continue;
    std::vector<std::uint32_t> slots;
    for (const auto& row : rows) slots.push_back(row.slot);
    auto moved = make_round({round.level, round.per_replicate, std::move(slots), nullptr});
    make_room(moved);
    for (std::uint32_t k = 0; k < options_.replicates; ++k)
      for (std::size_t i = 0; i < rows.size(); ++i)
        std::copy_n(rows[i].hits + k * rows[i].stride, n, moved.hits_of(k, i));
    round = std::move(moved);
  }
  shares_.set_owners(std::move(owners));
}

}  // namespace luxel
