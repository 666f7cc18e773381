// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/shadow_doubles.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "luxel/core/bounds.h"
#include "luxel/core/none.h"

namespace luxel {
namespace {

constexpr double beside = 2.0;          // in reach: lines that are nearer to each other are one
constexpr double parallel_sine = 0.05;  // between lines that may be one

// The box of a line and its surroundings.
Box<Vec3d> box_around(const EdgeShadow& line, double margin) {
  return {glm::min(line.ends[0], line.ends[1]) - margin, glm::max(line.ends[0], line.ends[1]) + margin};
}

// The interval of a part that lies within `distance` of another one, which is nearly parallel.
Interval covered(const EdgeShadow& part, const EdgeShadow& by, double distance) {
  constexpr Interval nothing{1.0, 0.0};
  const auto along = by.ends[1] - by.ends[0];
  const auto length = glm::length(along);
  const auto unit = along / length;
  const auto step = part.ends[1] - part.ends[0];
  if (glm::length(glm::cross(unit, step)) > parallel_sine * glm::length(step)) return nothing;
  const auto off = [&](const Vec3d& p) { return glm::length(glm::cross(unit, p - by.ends[0])); };
  if (off(part.ends[0]) > distance || off(part.ends[1]) > distance) return nothing;
  const auto from = glm::dot(unit, part.ends[0] - by.ends[0]);
  const auto to = glm::dot(unit, part.ends[1] - by.ends[0]);
  const auto begin = std::clamp(-from / (to - from), 0.0, 1.0);
  const auto end = std::clamp((length - from) / (to - from), 0.0, 1.0);
  return {std::min(begin, end), std::max(begin, end)};
}

// Returns the parts of a line that the other lines do not cover.
std::vector<EdgeShadow> left_of(const EdgeShadow& part, const std::vector<EdgeShadow>& others,
                                const std::vector<Box<Vec3d>>& boxes, double reach) {
  std::vector<EdgeShadow> left{part};
  const auto box = box_around(part, beside * reach);
  for (std::size_t i = 0; i < others.size() && !left.empty(); ++i) {
    if (!box.meets(boxes[i])) continue;
    std::vector<EdgeShadow> next;
    for (const auto& l : left) {
      const auto hidden = covered(l, others[i], beside * reach);
      if (!(hidden.begin < hidden.end)) {
        next.push_back(l);
        continue;
      }
      const auto length = glm::distance(l.ends[0], l.ends[1]);
      if (hidden.begin * length > shortest_line * reach) next.push_back(part_of(l, {0.0, hidden.begin}));
      if ((1.0 - hidden.end) * length > shortest_line * reach) next.push_back(part_of(l, {hidden.end, 1.0}));
    }
    left = std::move(next);
  }
  return left;
}

}  // namespace

EdgeShadow part_of(const EdgeShadow& shadow, const Interval& interval) {
  auto part = shadow;
  const auto along = shadow.ends[1] - shadow.ends[0];
  part.ends = {shadow.ends[0] + interval.begin * along, shadow.ends[0] + interval.end * along};
  if (interval.end == 1.0) part.ends[1] = shadow.ends[1];
  if (interval.begin > 0.0) part.corner[0] = none;
  if (interval.end < 1.0) part.corner[1] = none;
  part.weight = shadow.weight * (interval.end - interval.begin);
  return part;
}

std::vector<EdgeShadow> without_doubles(std::vector<EdgeShadow> parts, double reach) {
  std::stable_sort(parts.begin(), parts.end(),
                   [](const EdgeShadow& a, const EdgeShadow& b) { return a.weight > b.weight; });
  std::vector<EdgeShadow> result;
  std::vector<Box<Vec3d>> boxes;
  for (const auto& part : parts)
    for (const auto& left : left_of(part, result, boxes, reach)) {
      result.push_back(left);
      boxes.push_back(box_around(left, beside * reach));
    }
  return result;
}

}  // namespace luxel
