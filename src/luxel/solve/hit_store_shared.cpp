// SPDX-License-Identifier: Apache-2.0
// The hits of several processes: who has which rows, and how they move.
#include <algorithm>
#include <numeric>

#include "luxel/solve/hit_store.h"

namespace luxel {

std::vector<std::uint32_t> HitStore::mine(std::vector<std::uint32_t> receivers) const {
  if (partition_.is_shared()) std::erase_if(receivers, [this](std::uint32_t s) { return !is_mine(s); });
  return receivers;
}

// The round of all processes; the first process has its hits.
HitRound HitStore::gathered(const HitRound& own) const {
  const auto receivers = partition_.all_gather_lists(own.receivers);  // in the order of processes
  std::vector<std::size_t> order(receivers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return receivers[a] < receivers[b]; });
  HitRound whole{own.level, own.per_replicate, {}, nullptr};
  for (const auto i : order) whole.receivers.push_back(receivers[i]);
  const auto streamed = partition_.all_gather_value(is_streamed_ ? 1 : 0);
  if (std::count(streamed.begin(), streamed.end(), 0) < std::ssize(streamed)) return whole;
  const auto n = std::size_t{own.per_replicate};
  const bool is_first = partition_.process() == 0;
  if (is_first)
    whole.hits =
        std::make_shared_for_overwrite<std::uint32_t[]>(options_.replicates * whole.hits_per_replicate());
  std::vector<std::size_t> sizes;
  for (const auto count : partition_.all_gather_value(own.receivers.size()))
    sizes.push_back(count * n * sizeof(std::uint32_t));
  std::vector<std::uint32_t> hits(is_first ? receivers.size() * n : 0);
  for (std::uint32_t r = 0; r < options_.replicates; ++r) {
    const auto from = std::span(own.hits.get() + r * own.hits_per_replicate(), own.hits_per_replicate());
    partition_.ranks()->gather_to_first(std::as_bytes(from), std::as_writable_bytes(std::span(hits)), sizes);
    if (!is_first) continue;
    auto* to = whole.hits.get() + r * whole.hits_per_replicate();
    for (const auto i : order) to = std::copy_n(&hits[i * n], n, to);
  }
  return whole;
}

void HitStore::all_gather_receivers(std::span<float> values, std::size_t width) const {
  if (!partition_.is_shared()) return;
  std::vector<RowPartition::Run> runs;
  for (std::size_t b = 0; b < blocks(); ++b) {
    const auto receiver = block_begins_[b];
    runs.push_back({partition_.owner(sides_.position[receiver]), receiver, block_begins_[b + 1] - receiver});
  }
  partition_.all_gather_runs(values, width, runs);
}

std::vector<HitRound> HitStore::rounds() const {
  if (!partition_.is_shared()) return {rounds_.begin(), rounds_.end()};
  std::vector<HitRound> all;
  for (const auto& round : rounds_) all.push_back(gathered(round));
  return all;
}

HitStore::Round HitStore::own_part(const Round& whole) const {
  auto own = make_round({whole.level, whole.per_replicate, mine(whole.receivers), nullptr});
  if (!whole.hits) return own;
  make_room(own);
  for (std::uint32_t r = 0; r < options_.replicates; ++r) {
    auto* to = own.hits_of(r, 0);
    for (std::size_t i = 0; i < whole.receivers.size(); ++i)
      if (is_mine(whole.receivers[i])) to = std::copy_n(whole.hits_of(r, i), whole.per_replicate, to);
  }
  return own;
}

void HitStore::learn_pace(const Round& own, std::span<const std::uint32_t> groups,
                          std::span<const double> job_seconds, double seconds) {
  if (!partition_.is_shared()) return;
  const auto jobs_per_group = groups.size() > 1 ? job_seconds.size() / (groups.size() - 1) : 0;
  double busy = 0.0;
  std::vector<double> cost(partition_.owners().size(), 0.0), receivers(cost.size(), 0.0);
  for (std::size_t g = 0; g + 1 < groups.size(); ++g) {
    double whole = 0.0;
    for (std::size_t j = 0; j < jobs_per_group; ++j) whole += job_seconds[g * jobs_per_group + j];
    busy += whole;
    for (auto i = groups[g]; i < groups[g + 1]; ++i) {
      const auto block = partition_.block_of(sides_.position[own.receivers[i]]);
      cost[block] += whole / (groups[g + 1] - groups[g]);
      receivers[block] += 1.0;
    }
  }
  if (!(busy > 0.0 && seconds > 0.0)) return;
  busy_seconds_ += busy;
  traced_seconds_ += seconds;
  seconds_per_receiver_.resize(cost.size(), 0.0);
  for (std::size_t b = 0; b < cost.size(); ++b)
    if (receivers[b] > 0.0) seconds_per_receiver_[b] = cost[b] / (receivers[b] * own.per_replicate);
}

ProcessTimes HitStore::balance(std::span<const double> more_rays, double other_seconds) {
  if (!partition_.is_shared()) return {{1.0}, {0.0}};
  ProcessTimes times;
  times.ready.resize(partition_.processes(), 0.0);
  const bool is_known = traced_seconds_ > 0.0 && !is_streamed_;
  times.speed = partition_.all_gather_value(is_known ? busy_seconds_ / traced_seconds_ : 0.0);
  busy_seconds_ = traced_seconds_ = 0.0;
  if (*std::min_element(times.speed.begin(), times.speed.end()) <= 0.0) {
    times.speed.assign(partition_.processes(), 1.0);
    return times;
  }
  std::vector<double> load(partition_.owners().size(), 0.0);
  for (std::size_t s = 0; s < more_rays.size(); ++s)
    load[partition_.block_of(sides_.position[s])] += more_rays[s];
  seconds_per_receiver_.resize(load.size(), 0.0);
  partition_.all_gather_blocks(std::span(seconds_per_receiver_));
  for (std::size_t b = 0; b < load.size(); ++b) load[b] *= seconds_per_receiver_[b];
  auto owners = balanced_owners(partition_.owners(), load, times.speed, other_seconds);
  if (owners != partition_.owners()) move_rows(std::move(owners));
  for (std::size_t b = 0; b < load.size(); ++b)
    times.ready[partition_.owners()[b]] += load[b] / times.speed[partition_.owners()[b]];
  return times;
}

// For each process and each round: the number of its receivers, the receivers, and their hits.
void HitStore::move_rows(std::vector<std::uint32_t> owners) {
  const auto own = partition_.process();
  const auto processes = partition_.processes();
  const auto owner_of = [&](std::uint32_t receiver) {
    return owners[partition_.block_of(sides_.position[receiver])];
  };
  std::vector<std::vector<std::uint32_t>> parcels(processes);
  for (const auto& round : rounds_) {
    std::vector<std::vector<std::uint32_t>> places(processes);  // receivers that move to each process
    for (std::uint32_t i = 0; i < round.receivers.size(); ++i)
      places[owner_of(round.receivers[i])].push_back(i);
    for (std::size_t r = 0; r < processes; ++r) {
      if (r == own) continue;
      auto& parcel = parcels[r];
      parcel.push_back(static_cast<std::uint32_t>(places[r].size()));
      for (const auto i : places[r]) parcel.push_back(round.receivers[i]);
      for (std::uint32_t k = 0; k < options_.replicates; ++k)
        for (const auto i : places[r])
          parcel.insert(parcel.end(), round.hits_of(k, i), round.hits_of(k, i) + round.per_replicate);
    }
  }
  const auto come = partition_.all_to_all(parcels);
  parcels.clear();
  std::vector<const std::uint32_t*> next;  // position of the next unread entry of each parcel
  for (const auto& parcel : come) next.push_back(parcel.data());
  for (auto& round : rounds_) {
    // Receivers with the position of the first replicate's hits, and the stride to the next replicate's.
    struct Row {
      std::uint32_t receiver;
      const std::uint32_t* hits;
      std::size_t stride;
    };
    const std::size_t n = round.per_replicate;
    std::vector<Row> rows;
    for (std::size_t i = 0; i < round.receivers.size(); ++i)
      if (owner_of(round.receivers[i]) == own)
        rows.push_back({round.receivers[i], round.hits_of(0, i), round.hits_per_replicate()});
    const auto stayed = rows.size();
    for (auto& at : next) {
      if (&at == &next[own]) continue;
      const std::size_t count = *at++;
      const auto* hits = at + count;
      const auto middle = std::ssize(rows);
      for (std::size_t i = 0; i < count; ++i) rows.push_back({at[i], hits + i * n, count * n});
      std::inplace_merge(rows.begin(), rows.begin() + middle, rows.end(),
                         [](const Row& a, const Row& b) { return a.receiver < b.receiver; });
      at = hits + options_.replicates * count * n;
    }
    if (stayed == round.receivers.size() && stayed == rows.size()) continue;
    std::vector<std::uint32_t> receivers;
    for (const auto& row : rows) receivers.push_back(row.receiver);
    auto moved = make_round({round.level, round.per_replicate, std::move(receivers), nullptr});
    make_room(moved);
    for (std::uint32_t k = 0; k < options_.replicates; ++k)
      for (std::size_t i = 0; i < rows.size(); ++i)
        std::copy_n(rows[i].hits + k * rows[i].stride, n, moved.hits_of(k, i));
    round = std::move(moved);
  }
  partition_.set_owners(std::move(owners));
}

}  // namespace luxel
