// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "luxel/lighting/calculation_grid.h"

namespace luxel {
namespace {

using Line = std::vector<Vec2d>;

// Joins segments at their ends to lines. Ends closer than a tenth of a millimetre are the same.
class SegmentJoiner {
 public:
  void add(const Vec2d& a, const Vec2d& b) {
    const auto p = node(a), q = node(b);
    if (p == q) return;
    const auto edge = std::minmax(p, q);
    if (!known_.emplace(edge, true).second) return;
    next_[p].push_back(q);
    next_[q].push_back(p);
  }

  std::vector<Line> lines() {
    std::vector<Line> lines;
    for (const bool from_ends : {true, false})  // open lines first, then closed ones
      for (std::size_t i = 0; i < at_.size(); ++i)
        while (!next_[i].empty() && (!from_ends || next_[i].size() != 2)) lines.push_back(straight(walk(i)));
    return lines;
  }

 private:
  std::size_t node(const Vec2d& p) {
    constexpr double cell = 1e-4;  // m
    const std::pair key(std::llround(p.x / cell), std::llround(p.y / cell));
    const auto [place, is_new] = nodes_.emplace(key, at_.size());
    if (is_new) {
      at_.push_back(p);
      next_.emplace_back();
    }
    return place->second;
  }
  Line walk(std::size_t i) {
    Line line{at_[i]};
    while (!next_[i].empty()) {
      const auto j = next_[i].back();
      next_[i].pop_back();
      next_[j].erase(std::find(next_[j].begin(), next_[j].end(), i));
      line.push_back(at_[j]);
      i = j;
    }
    return line;
  }
  static Line straight(const Line& line) {
    Line result;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (!result.empty() && i + 1 < line.size()) {
        const auto a = line[i] - result.back(), b = line[i + 1] - line[i];
        if (std::abs(a.x * b.y - a.y * b.x) < 1e-3 * glm::length(a) * glm::length(b) && glm::dot(a, b) > 0.0)
          continue;
      }
      result.push_back(line[i]);
    }
    return result;
  }

  std::map<std::pair<long long, long long>, std::size_t> nodes_;
  std::map<std::pair<std::size_t, std::size_t>, bool> known_;
  std::vector<Vec2d> at_;
  std::vector<std::vector<std::size_t>> next_;
};

}  // namespace

std::vector<Line> plan_of(const PatchSet& patches, const CalculationGrid& grid, double lift) {
  const auto normal = glm::cross(grid.along, grid.across);
  SegmentJoiner joiner;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto corners = patches.points(p);
    std::vector<Vec2d> ends;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = patches.in_file(corners[i]) - grid.corner,
                 b = patches.in_file(corners[(i + 1) % 3]) - grid.corner;
      const auto of_a = glm::dot(a, normal) - lift, of_b = glm::dot(b, normal) - lift;
      if ((of_a < 0.0) == (of_b < 0.0)) continue;
      const auto at = a + of_a / (of_a - of_b) * (b - a);
      ends.push_back({glm::dot(at, grid.along), glm::dot(at, grid.across)});
    }
    if (ends.size() == 2) joiner.add(ends[0], ends[1]);
  }
  return joiner.lines();
}

}  // namespace luxel
