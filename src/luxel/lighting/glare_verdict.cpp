// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/glare_verdict.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace luxel {
namespace {

// Returns whether the vertical line through a point meets the polygon, by the parity of crossings in the
// level plane.
bool is_above(const std::vector<Vec3d>& polygon, const Vec3d& point, const Vec3d& up) {
  const auto along = glm::normalize(std::abs(up.x) < 0.9 ? glm::cross(up, Vec3d(1.0, 0.0, 0.0))
                                                         : glm::cross(up, Vec3d(0.0, 1.0, 0.0)));
  const auto across = glm::cross(up, along);
  bool is_inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const auto a = polygon[i] - point, b = polygon[j] - point;
    const auto ay = glm::dot(a, across), by = glm::dot(b, across);
    if ((ay > 0.0) == (by > 0.0)) continue;
    const auto ax = glm::dot(a, along), bx = glm::dot(b, along);
    if (ax + ay / (ay - by) * (bx - ax) > 0.0) is_inside = !is_inside;
  }
  return is_inside;
}

Verdict judge_highest(std::span<const NamedGlare> observers, double required, const std::string& among) {
  const NamedGlare* highest = nullptr;
  for (const auto& o : observers)
    if (highest == nullptr || o.glare.ugr > highest->glare.ugr) highest = &o;
  Figure figure;
  if (highest != nullptr) {
    const auto& glare = highest->glare;
    figure = {glare.ugr, glare.low, glare.high, glare.sampling, glare.sampling};
  }
  auto verdict = judge("UGR", figure, required, false);
  if (highest == nullptr || figure.value > 1e9) {
    verdict.compliance = Compliance::not_known;
    verdict.more_rays = verdict.solution_factor = std::nullopt;
    verdict.note = highest == nullptr ? "there are no observers"
                                      : fmt::format("observer {} sees a dark background", highest->name);
  } else if (std::isinf(figure.value)) {
    verdict.note = fmt::format("no lamp dazzles {}", among);
  } else {
    verdict.note = fmt::format("highest of {}: {}", among, highest->name);
  }
  return verdict;
}

}  // namespace

Verdict judge_glare(std::span<const NamedGlare> observers, double required) {
  return judge_highest(observers, required, "all observers");
}

std::optional<Verdict> judge_glare(const CalculationArea& area, std::span<const NamedGlare> observers,
                                   const Vec3d& up) {
  if (!area.requirement.ugr) return std::nullopt;
  std::vector<NamedGlare> inside;
  for (const auto& o : observers)
    if (area.polygon.size() >= 3 && is_above(area.polygon, o.eye, up)) inside.push_back(o);
  if (inside.empty()) return judge_glare(observers, *area.requirement.ugr);
  return judge_highest(inside, *area.requirement.ugr,
                       inside.size() == observers.size() ? "all observers" : "the observers in this area");
}

}  // namespace luxel
