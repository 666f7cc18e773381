// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/piece_shares.h"

#include <algorithm>
#include <numeric>

namespace luxel {
namespace {

constexpr std::uint32_t positions_a_piece = 64;
constexpr double second_part = 0.5, last_part = 0.75;  // shares of a rank's work, where they begin
constexpr double guess = 1e-5;  // s a sample, as long as nothing is known: pieces are dealt evenly

}  // namespace

PieceShares::PieceShares(const RowShares& shares, const GatherSides& sides) : shares_(shares), sides_(sides) {
  if (!shares.ranks() || sides.size() == 0) return;
  const auto last = *std::max_element(sides.position.begin(), sides.position.end()) / positions_a_piece;
  for (std::size_t piece = 0; piece < 2 * (last + 1); ++piece)
    owners_.push_back(static_cast<std::uint32_t>(piece / 2 % shares.ranks()->size()));
  parts_.resize(owners_.size(), 0);
  seconds_a_sample_.resize(owners_.size(), 0.0);
}

std::size_t PieceShares::piece_of(std::size_t slot) const {
  return 2 * (sides_.position[slot] / positions_a_piece) + (slot < sides_.fronts ? 0 : 1);
}

void PieceShares::learn(std::span<const std::uint32_t> slots, std::span<const double> seconds) {
  if (!shares_.ranks()) return;
  for (std::size_t i = 0; i < slots.size();) {
    const auto piece = piece_of(slots[i]);
    double sum = 0.0;
    std::size_t count = 0;
    for (; i < slots.size() && piece_of(slots[i]) == piece; ++i, ++count) sum += seconds[i];
    if (sum > 0.0) seconds_a_sample_[piece] = sum / static_cast<double>(count);
  }
}

std::vector<double> PieceShares::expected(std::span<const double> more) const {
  double sum = 0.0;
  double known = 0.0;
  for (const auto s : seconds_a_sample_) {
    sum += s;
    known += s > 0.0 ? 1.0 : 0.0;
  }
  const auto usual = known > 0.0 ? sum / known : guess;
  std::vector<double> seconds(owners_.size(), 0.0);
  for (std::size_t s = 0; s < more.size(); ++s) {
    if (!(more[s] > 0.0)) continue;
    const auto piece = piece_of(s);
    seconds[piece] += more[s] * (seconds_a_sample_[piece] > 0.0 ? seconds_a_sample_[piece] : usual);
  }
  return seconds;
}

double PieceShares::expected_seconds(std::span<const double> more) const {
  if (!shares_.ranks()) return 0.0;
  const auto seconds = expected(more);
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

void PieceShares::deal(std::span<const double> more, const RankTimes& times) {
  if (!shares_.ranks()) return;
  load_ = expected(more);
  owners_ = dealt_pieces(load_, times);
  std::vector<double> whole(times.ready.size(), 0.0), done(whole);
  for (std::size_t p = 0; p < load_.size(); ++p) whole[owners_[p]] += load_[p];
  for (const auto p : heaviest_first(load_)) {  // the small ones last
    const auto rank = owners_[p];
    const auto share = whole[rank] > 0.0 ? done[rank] / whole[rank] : 0.0;
    parts_[p] = share < second_part ? 0 : share < last_part ? 1 : 2;
    done[rank] += load_[p];
  }
}

void PieceShares::deal_rest(RankTimes times) {
  if (!shares_.ranks()) return;
  std::vector<std::uint32_t> rest;
  std::vector<double> load;
  for (std::uint32_t p = 0; p < load_.size(); ++p) {
    if (parts_[p] == 1) times.ready[owners_[p]] += load_[p] / times.speed[owners_[p]];
    if (parts_[p] < 2) continue;
    rest.push_back(p);
    load.push_back(load_[p]);
  }
  const auto dealt = dealt_pieces(load, times);
  for (std::size_t i = 0; i < rest.size(); ++i) owners_[rest[i]] = dealt[i];
}

void PieceShares::share(std::span<std::vector<float>> lists, std::size_t width,
                        std::span<const std::uint32_t> slots) {
  if (!shares_.ranks()) return;
  const auto runs = RowShares::runs_of(
      slots.size(), [&](std::size_t i) { return slots[i]; },
      [&](std::size_t i) { return owners_[piece_of(slots[i])]; });
  for (auto& list : lists) shares_.share_runs(std::span(list), width, runs);
  shares_.share_of(
      std::span(seconds_a_sample_), 1, owners_.size(), [](std::size_t p) { return p; },
      [this](std::size_t p) { return owners_[p]; });
}

}  // namespace luxel
