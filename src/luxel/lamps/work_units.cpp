// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/work_units.h"

#include <algorithm>
#include <numeric>

namespace luxel {
namespace {

constexpr std::uint32_t positions_per_unit = 64;
// Fractions of a process's work where these parts begin.
constexpr double second_part = 0.5, last_part = 0.75;
constexpr double guess = 1e-5;  // s per sample before any is measured; only ratios matter

}  // namespace

WorkUnits::WorkUnits(const RowPartition& partition, const GatherSides& sides)
    : partition_(partition), sides_(sides) {
  if (!partition.is_shared() || sides.size() == 0) return;
  const auto last = *std::max_element(sides.position.begin(), sides.position.end()) / positions_per_unit;
  for (std::size_t unit = 0; unit < 2 * (last + 1); ++unit)
    owners_.push_back(static_cast<std::uint32_t>(unit / 2 % partition.processes()));
  parts_.resize(owners_.size(), 0);
  seconds_per_sample_.resize(owners_.size(), 0.0);
}

std::size_t WorkUnits::unit_of(std::size_t receiver) const {
  return 2 * (sides_.position[receiver] / positions_per_unit) + (receiver < sides_.fronts ? 0 : 1);
}

void WorkUnits::learn(std::span<const std::uint32_t> receivers, std::span<const double> seconds) {
  if (!partition_.is_shared()) return;
  for (std::size_t i = 0; i < receivers.size();) {
    const auto unit = unit_of(receivers[i]);
    double sum = 0.0;
    std::size_t count = 0;
    for (; i < receivers.size() && unit_of(receivers[i]) == unit; ++i, ++count) sum += seconds[i];
    if (sum > 0.0) seconds_per_sample_[unit] = sum / static_cast<double>(count);
  }
}

std::vector<double> WorkUnits::expected(std::span<const double> more) const {
  double sum = 0.0;
  double known = 0.0;
  for (const auto s : seconds_per_sample_) {
    sum += s;
    known += s > 0.0 ? 1.0 : 0.0;
  }
  const auto usual = known > 0.0 ? sum / known : guess;
  std::vector<double> seconds(owners_.size(), 0.0);
  for (std::size_t s = 0; s < more.size(); ++s) {
    if (!(more[s] > 0.0)) continue;
    const auto unit = unit_of(s);
    seconds[unit] += more[s] * (seconds_per_sample_[unit] > 0.0 ? seconds_per_sample_[unit] : usual);
  }
  return seconds;
}

double WorkUnits::expected_seconds(std::span<const double> more) const {
  if (!partition_.is_shared()) return 0.0;
  const auto seconds = expected(more);
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

void WorkUnits::deal(std::span<const double> more, const ProcessTimes& times) {
  if (!partition_.is_shared()) return;
  load_ = expected(more);
  owners_ = dealt_units(load_, times);
  std::vector<double> whole(times.ready.size(), 0.0), done(whole);
  for (std::size_t p = 0; p < load_.size(); ++p) whole[owners_[p]] += load_[p];
  for (const auto p : heaviest_first(load_)) {  // small units last
    const auto owner = owners_[p];
    const auto finished = whole[owner] > 0.0 ? done[owner] / whole[owner] : 0.0;
    parts_[p] = finished < second_part ? 0 : finished < last_part ? 1 : 2;
    done[owner] += load_[p];
  }
}

void WorkUnits::deal_rest(ProcessTimes times) {
  if (!partition_.is_shared()) return;
  std::vector<std::uint32_t> rest;
  std::vector<double> load;
  for (std::uint32_t p = 0; p < load_.size(); ++p) {
    if (parts_[p] == 1) times.ready[owners_[p]] += load_[p] / times.speed[owners_[p]];
    if (parts_[p] < 2) continue;
    rest.push_back(p);
    load.push_back(load_[p]);
  }
  const auto dealt = dealt_units(load, times);
  for (std::size_t i = 0; i < rest.size(); ++i) owners_[rest[i]] = dealt[i];
}

void WorkUnits::all_gather(std::span<std::vector<float>> lists, std::size_t width,
                           std::span<const std::uint32_t> receivers) {
  if (!partition_.is_shared()) return;
  const auto runs = RowPartition::runs_of(
      receivers.size(), [&](std::size_t i) { return receivers[i]; },
      [&](std::size_t i) { return owners_[unit_of(receivers[i])]; });
  for (auto& list : lists) partition_.all_gather_runs(std::span(list), width, runs);
  partition_.all_gather_rows(
      std::span(seconds_per_sample_), 1, owners_.size(), [](std::size_t p) { return p; },
      [this](std::size_t p) { return owners_[p]; });
}

}  // namespace luxel
