// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/closed_patches.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

constexpr float fractions = 65536.0f;  // both patches at an edge get the same fraction of it, from either end

}  // namespace

ClosedPatches::ClosedPatches(const PatchSet& patches, const SmoothLight& light)
    : patches_(patches), light_(light), cuts_(cut_at_hanging_vertices(patches)) {
  for (auto& cut : cuts_)
    for (auto& point : cut.points) point.fraction = std::round(point.fraction * fractions) / fractions;
}

std::vector<std::array<DrawnPoint, 3>> ClosedPatches::triangles(std::uint32_t patch) const {
  const auto& smooth = light_.corners[patch];
  const auto drawn = [&](const BorderVertex& point) {
    const auto after = point.is_corner() ? point.edge : (point.edge + 1) % 3;
    return DrawnPoint{point.vertex, {smooth[point.edge], smooth[after]}, point.fraction, point.weights()};
  };
  const auto cut = std::lower_bound(cuts_.begin(), cuts_.end(), patch,
                                    [](const PatchCut& c, std::uint32_t number) { return c.patch < number; });
  if (cut == cuts_.end() || cut->patch != patch) {
    const auto& corners = patches_.corners[patch];
    return {{drawn({corners[0], 0}), drawn({corners[1], 1}), drawn({corners[2], 2})}};
  }
  std::vector<std::array<DrawnPoint, 3>> triangles;
  for (const auto& t : cut->triangles)
    triangles.push_back({drawn(cut->points[t[0]]), drawn(cut->points[t[1]]), drawn(cut->points[t[2]])});
  return triangles;
}

}  // namespace luxel
