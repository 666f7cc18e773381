// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/closed_patches.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "luxel/surface/cut_along_edges.h"
#include "luxel/surface/hanging_vertices.h"

namespace luxel {
namespace {

constexpr float fractions = 65536.0f;  // both patches at an edge get the same fraction of it, from either end

}  // namespace

ClosedPatches::ClosedPatches(const PatchSet& patches, const SmoothLight& light)
    : patches_(patches), light_(light) {
  for (const auto& h : find_all_hanging_vertices(patches))
    on_edges_.push_back({h.patch, h.edge, h.vertex, std::round(h.fraction * fractions) / fractions});
  const auto order = [](const EdgePoint& p) { return std::tuple(p.patch, p.edge, p.fraction, p.vertex); };
  std::sort(on_edges_.begin(), on_edges_.end(),
            [&](const auto& a, const auto& b) { return order(a) < order(b); });
}

std::vector<std::array<DrawnPoint, 3>> ClosedPatches::triangles(std::uint32_t patch) const {
  const auto& corners = patches_.corners[patch];
  const auto& smooth = light_.corners[patch];
  auto next = std::lower_bound(on_edges_.begin(), on_edges_.end(), patch,
                               [](const EdgePoint& p, std::uint32_t number) { return p.patch < number; });
  const bool is_whole = next == on_edges_.end() || next->patch != patch;
  std::vector<DrawnPoint> points;
  std::vector<BorderPoint> border;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto after = (k + 1) % 3;
    Vec3 here(0.0f), there(0.0f);
    here[static_cast<int>(k)] = there[static_cast<int>(after)] = 1.0f;
    points.push_back({corners[k], {smooth[k], smooth[k]}, 0.0f, here});
    border.push_back({Vec3d(patches_.vertices[corners[k]]), 1u << k | 1u << (k + 2) % 3});
    for (; !is_whole && next != on_edges_.end() && next->patch == patch && next->edge == k; ++next) {
      points.push_back(
          {next->vertex, {smooth[k], smooth[after]}, next->fraction, glm::mix(here, there, next->fraction)});
      border.push_back({Vec3d(patches_.vertices[next->vertex]), 1u << k});
    }
  }
  if (is_whole) return {{points[0], points[1], points[2]}};
  std::vector<std::array<DrawnPoint, 3>> triangles;
  for (const auto& t : cut_along_edges(border))
    triangles.push_back({points[t[0]], points[t[1]], points[t[2]]});
  return triangles;
}

}  // namespace luxel
