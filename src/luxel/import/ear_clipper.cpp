// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/ear_clipper.h"

#include <algorithm>
#include <cmath>

namespace luxel {

EarClipper::EarClipper(std::span<const glm::dvec2> points)
    : points_(points),
      next_(points.size()),
      previous_(points.size()),
      may_block_(points.size()),
      left_(points.size()),
      max_work_(20'000'000 + 2'000 * points.size()) {
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    next_[i] = (i + 1) % n;
    previous_[i] = (i + n - 1) % n;
  }
  for (std::uint32_t i = 0; i < n; ++i) may_block_[i] = !(turn_at(i) > 0.0);
  build_grid();
}

// About one corner of the ring per cell, as a counting sort; a small ring has one cell.
void EarClipper::build_grid() {
  std::vector<std::uint32_t> ring(left_);
  for (auto& corner : ring) corner = here_ = next_[here_];
  low_ = points_[here_];
  auto high = low_;
  for (const auto corner : ring) {
    low_ = glm::min(low_, points_[corner]);
    high = glm::max(high, points_[corner]);
  }
  side_ = left_ < 64 ? 1 : static_cast<std::size_t>(std::sqrt(static_cast<double>(left_)));
  for (int axis = 0; axis < 2; ++axis) {
    const auto size = high[axis] - low_[axis];
    cells_per_unit_[axis] = size > 0.0 ? static_cast<double>(side_) / size : 0.0;
  }

  const auto cell_of = [&](std::uint32_t c) { return row(points_[c].y) * side_ + column(points_[c].x); };
  cell_begin_.assign(side_ * side_ + 1, 0);
  for (const auto corner : ring) ++cell_begin_[cell_of(corner) + 1];
  for (std::size_t i = 1; i < cell_begin_.size(); ++i) cell_begin_[i] += cell_begin_[i - 1];
  auto place = cell_begin_;
  cell_corner_.resize(left_);
  for (const auto corner : ring) cell_corner_[place[cell_of(corner)]++] = corner;
}

std::size_t EarClipper::column(double x) const {
  return std::min(static_cast<std::size_t>((x - low_.x) * cells_per_unit_.x), side_ - 1);
}

std::size_t EarClipper::row(double y) const {
  return std::min(static_cast<std::size_t>((y - low_.y) * cells_per_unit_.y), side_ - 1);
}

void EarClipper::clip(Triangles& triangles) {
  auto demand = Demand::ear;
  while (left_ > 3 && work_ < max_work_) {
    const bool has_cut = go_round(demand, triangles) > 0;
    demand = has_cut ? Demand::ear : static_cast<Demand>(static_cast<int>(demand) + 1);
    if (2 * left_ < cell_corner_.size()) build_grid();
  }
  while (left_ >= 3) cut(next_[here_], triangles);
}

// Visits each corner once and returns the number of cuts. Where ears are frequent it leaves every second one
// for the next round: fewer slivers. Where they are rare (along a winding corridor only its two ends are
// ears) it visits both neighbours of a cut at once. Cuts that break the shape are limited to one per round,
// as true ears may follow.
std::size_t EarClipper::go_round(Demand demand, Triangles& triangles) {
  std::size_t cuts = 0;
  auto visits = left_;
  for (; visits > 0 && left_ > 3 && work_ < max_work_; --visits, here_ = next_[here_]) {
    if (!meets(here_, demand)) continue;
    cut(here_, triangles);
    ++cuts;
    if (demand >= Demand::convex) {
      here_ = next_[here_];  // a corner that was cut is no longer in the ring
      break;
    }
    if (are_ears_few_) {
      here_ = previous_[previous_[here_]];
      visits += 2;
    } else {
      here_ = next_[here_];
    }
  }
  are_ears_few_ = 8 * cuts < left_;
  return cuts;
}

void EarClipper::cut(std::uint32_t corner, Triangles& triangles) {
  const auto before = previous_[corner], after = next_[corner];
  triangles.push_back({before, corner, after});
  next_[before] = after;
  previous_[after] = before;
  --left_;
  may_block_[corner] = false;
  may_block_[before] = !(turn_at(before) > 0.0);
  may_block_[after] = !(turn_at(after) > 0.0);
}

bool EarClipper::meets(std::uint32_t corner, Demand demand) {
  ++work_;
  switch (demand) {
    case Demand::ear:
      return is_ear(corner);
    case Demand::flat:
      return turn_at(corner) == 0.0;
    case Demand::convex:
      return turn_at(corner) > 0.0;
    case Demand::none:
      break;
  }
  return true;
}

bool EarClipper::is_ear(std::uint32_t corner) {
  if (!(turn_at(corner) > 0.0)) return false;
  const auto &a = points_[previous_[corner]], &b = points_[corner], &c = points_[next_[corner]];
  const auto low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
  for (auto y = row(low.y); y <= row(high.y); ++y) {
    const auto begin = cell_begin_[y * side_ + column(low.x)],
               end = cell_begin_[y * side_ + column(high.x) + 1];
    work_ += 1 + end - begin;
    for (auto i = begin; i < end; ++i)
      if (may_block_[cell_corner_[i]] && blocks(cell_corner_[i], corner)) return false;
  }
  return true;
}

// Returns whether another corner lies in the ear or on its boundary. A corner that coincides with one of the
// ear, as along a seam, blocks it only where the polygon continues from there into the ear.
bool EarClipper::blocks(std::uint32_t other, std::uint32_t corner) const {
  const auto before = previous_[corner], after = next_[corner];
  if (other == before || other == corner || other == after) return false;
  const auto &a = points_[before], &b = points_[corner], &c = points_[after], &p = points_[other];
  if (p == a) return leads_between(other, b, c);
  if (p == b) return leads_between(other, c, a);
  if (p == c) return leads_between(other, a, b);
  return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
}

// Returns whether one of the two edges at a corner points strictly between the directions to right and left.
bool EarClipper::leads_between(std::uint32_t other, const glm::dvec2& right, const glm::dvec2& left) const {
  const auto& at = points_[other];
  const auto is_between = [&](const glm::dvec2& q) {
    return turn(at, right, q) > 0.0 && turn(at, q, left) > 0.0;
  };
  return is_between(points_[next_[other]]) || is_between(points_[previous_[other]]);
}

double EarClipper::turn_at(std::uint32_t corner) const {
  return turn(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
}

}  // namespace luxel
