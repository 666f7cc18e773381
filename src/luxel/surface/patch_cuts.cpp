// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/patch_cuts.h"

#include <algorithm>
#include <span>
#include <tuple>

#include "luxel/surface/cut_along_edges.h"
#include "luxel/surface/hanging_vertices.h"

namespace luxel {
namespace {

// hanging: on this patch, sorted by edge and fraction.
PatchCut cut(const PatchSet& patches, std::uint32_t patch, std::span<const HangingVertex> hanging) {
  PatchCut done{patch, {}, {}};
  std::vector<BorderPoint> border;
  const auto add = [&](const BorderVertex& point, unsigned edges) {
    // The same vertex may lie near two edges of a sliver.
    for (const auto& known : done.points)
      if (known.vertex == point.vertex) return;
    done.points.push_back(point);
    border.push_back({Vec3d(patches.vertices[point.vertex]), edges});
  };
  auto next = hanging.begin();
  for (unsigned k = 0; k < 3; ++k) {
    add({patches.corners[patch][k], k, 0.0f}, 1u << k | 1u << (k + 2) % 3);
    for (; next != hanging.end() && next->edge == k; ++next) add({next->vertex, k, next->fraction}, 1u << k);
  }
  done.triangles = cut_along_edges(border);
  return done;
}

}  // namespace

Vec3 BorderVertex::weights() const {
  Vec3 weights(0.0f);
  weights[static_cast<int>(edge)] = 1.0f - fraction;
  weights[static_cast<int>((edge + 1) % 3)] = fraction;
  return weights;
}

std::vector<PatchCut> cut_at_hanging_vertices(const PatchSet& patches) {
  auto hanging = find_all_hanging_vertices(patches);
  std::sort(hanging.begin(), hanging.end(), [](const HangingVertex& a, const HangingVertex& b) {
    return std::tuple(a.patch, a.edge, a.fraction, a.vertex) <
           std::tuple(b.patch, b.edge, b.fraction, b.vertex);
  });
  std::vector<PatchCut> cuts;
  for (auto next = hanging.begin(); next != hanging.end();) {
    const auto first = next;
    while (next != hanging.end() && next->patch == first->patch) ++next;
    cuts.push_back(cut(patches, first->patch, {first, next}));
  }
  return cuts;
}

}  // namespace luxel
